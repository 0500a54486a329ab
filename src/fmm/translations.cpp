// Translates expansions from box to box: M2M (08.12), L2L (08.13), and M2L (08.10) with (08.11) for
// as many source boxes at once as a vector register has lanes.
#include "fmm/translations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "double_layer/lanes.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr std::size_t most_columns = Translations::most_order + 1;

// Returns a complex number times the coefficients of phi and psi.
Coefficients times(Complex factor, const Coefficients& c) {
  const double x = factor.real(), y = factor.imag();
  return {x * c[0] - y * c[1], x * c[1] + y * c[0], x * c[2] - y * c[3], x * c[3] + y * c[2]};
}

// Returns a complex number times the coefficient of phi, in the place of the coefficient of psi.
Coefficients to_psi(Complex factor, const Coefficients& c) {
  const double x = factor.real(), y = factor.imag();
  return {0.0, 0.0, x * c[0] - y * c[1], x * c[1] + y * c[0]};
}

// A shift d is balanced if it is longer than this share of the smaller box's radius R. Otherwise
// the powers (R / d)^k could exceed the range of numbers.
constexpr double least_shift = 0.02;

using Table = std::array<Coefficients, most_columns>;

}  // namespace

Translations::Translations(int order) : order_(order) {
  require(order >= 1 && order <= most_order, "the order of an expansion must be from 1 to ",
          most_order, ", got ", order);
  binomial_.setZero(order + 1, order + 1);
  for (int n = 0; n <= order; ++n) {
    for (int k = 0; k <= n; ++k) {
      binomial_(n, k) = k == 0 || k == n ? 1.0 : binomial_(n - 1, k - 1) + binomial_(n - 1, k);
    }
  }
  // H_lk = binomial(k + l - 1, l) (08.10): 1 for l = 0 or k = 1, else H_(l-1,k) + H_(l,k-1). Column
  // 0 belongs to the logarithm: H_00 = 0 and H_l0 = -1 / l.
  m2l_.setZero(order + 1, order + 1);
  for (int l = 0; l <= order; ++l) {
    m2l_(l, 0) = l == 0 ? 0.0 : -1.0 / l;
    for (int k = 1; k <= order; ++k) {
      m2l_(l, k) = l == 0 || k == 1 ? 1.0 : m2l_(l - 1, k) + m2l_(l, k - 1);
    }
  }
}

// (08.12), and for the logarithm log(zeta - d) = log(zeta) - sum_l (d / zeta)^l / l.
void Translations::m2m(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
                       Eigen::Ref<Expansion> sum) const {
  const Complex d = from.centre - to.centre;
  const bool balanced = std::abs(d) > least_shift * from.radius;
  const Complex step = d / to.radius;
  // A_k (R_1 / d)^k, or A_k (R_1 / R_2)^k if d is too short to divide by
  const Complex ratio = balanced ? from.radius / d : Complex{from.radius / to.radius};
  Table scaled;
  Complex power = 1.0;
  for (int k = 1; k <= order_; ++k) {
    power *= ratio;
    scaled[static_cast<std::size_t>(k)] = times(power, expansion.col(k));
  }
  const Coefficients logarithm = expansion.col(0);
  sum.col(0) += logarithm;
  Coefficients previous = -logarithm;  // (l - 1) A'_(l-1), for l = 1 that of the logarithm
  power = 1.0;
  for (int l = 1; l <= order_; ++l) {
    power *= step;
    Coefficients moved = Coefficients::Zero();
    if (balanced) {
      for (int k = 1; k <= l; ++k) {
        moved += binomial_(l - 1, k - 1) * scaled[static_cast<std::size_t>(k)];
      }
      moved = times(power, moved - logarithm / l);
    } else {
      Complex shift = 1.0;  // (d / R_2)^(l-k)
      for (int k = l; k >= 1; --k, shift *= step) {
        moved += binomial_(l - 1, k - 1) * times(shift, scaled[static_cast<std::size_t>(k)]);
      }
      moved -= times(power, logarithm / l);
    }
    sum.col(l) += moved + to_psi(std::conj(step), previous);
    previous = l * moved;
  }
}

// (08.13)
void Translations::l2l(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
                       Eigen::Ref<Expansion> sum) const {
  const Complex d = to.centre - from.centre;
  const bool balanced = std::abs(d) > least_shift * to.radius;
  const Complex step = d / from.radius;
  const Complex ratio = balanced ? to.radius / d : Complex{to.radius / from.radius};
  Table scaled;
  Complex power = 1.0;
  for (int l = 0; l <= order_; ++l) {
    scaled[static_cast<std::size_t>(l)] =
        balanced ? times(power, expansion.col(l)) : Coefficients(expansion.col(l));
    power *= step;
  }
  power = 1.0;
  for (int m = 0; m <= order_; ++m) {
    Coefficients moved = Coefficients::Zero();
    if (balanced) {
      for (int l = m; l <= order_; ++l) {
        moved += binomial_(l, m) * scaled[static_cast<std::size_t>(l)];
      }
    } else {
      Complex shift = 1.0;  // (d / R_1)^(l-m)
      for (int l = m; l <= order_; ++l, shift *= step) {
        moved += binomial_(l, m) * times(shift, scaled[static_cast<std::size_t>(l)]);
      }
    }
    moved = times(power, moved);
    power *= ratio;
    sum.col(m) += moved;
    if (m > 0) sum.col(m - 1) += to_psi(static_cast<double>(m) * std::conj(d) / to.radius, moved);
  }
}

namespace {

// Real and imaginary parts of the coefficients of phi and psi, each for a register of boxes; Rows
// has a row for each power.
using Parts = std::array<Lanes, 4>;
constexpr int rows_at_once = lane_count == 8 ? 4 : 2;  // the sums of these rows fit into registers
using Rows = std::array<Parts, most_columns + rows_at_once>;

// Computes Y = H X, the matrix product of (08.10).
void multiply(const double* h, int columns, const Rows& x, Rows& y) {
  for (int first = 0; first < columns; first += rows_at_once) {
    std::array<Parts, rows_at_once> sum{};
    std::array<const double*, rows_at_once> row{};
    for (int i = 0; i < rows_at_once; ++i) {
      row[static_cast<std::size_t>(i)] = h + std::min(first + i, columns - 1) * columns;
    }
    for (int k = 0; k < columns; ++k) {
      const Parts& column = x[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < rows_at_once; ++i) {
        const double factor = row[i][k];
        for (std::size_t part = 0; part < 4; ++part) sum[i][part] += factor * column[part];
      }
    }
    for (std::size_t i = 0; i < rows_at_once; ++i) y[static_cast<std::size_t>(first) + i] = sum[i];
  }
}

struct ComplexLanes {
  Lanes x, y;

  void operator*=(const ComplexLanes& other) {
    const Lanes real = x * other.x - y * other.y;
    y = x * other.y + y * other.x;
    x = real;
  }
  Parts times(const Parts& c) const {
    return {x * c[0] - y * c[1], x * c[1] + y * c[0], x * c[2] - y * c[3], x * c[3] + y * c[2]};
  }
};

// The source boxes of one register. Lanes beyond the end of the list repeat the last box with zero
// coefficients.
struct Batch {
  Batch(const std::vector<Box>& boxes, const Expansions& multipole, std::span<const Index> list,
        Index field, const Box& target) {
    for (int s = 0; s < lane_count; ++s) {
      const auto lane = static_cast<std::size_t>(s);
      const Index box = list[std::min(lane, list.size() - 1)];
      const Box& source = boxes[static_cast<std::size_t>(box)];
      from[lane] = multipole(box, field).data();
      on[s] = lane < list.size() ? 1.0 : 0.0;
      distance.x[s] = target.centre.real() - source.centre.real();
      distance.y[s] = target.centre.imag() - source.centre.imag();
      radius[s] = source.radius;
    }
    const Lanes inverse2 = 1.0 / (distance.x * distance.x + distance.y * distance.y);
    inverse = {distance.x * inverse2, -(distance.y * inverse2)};
  }

  // Returns the coefficients of power k for all lanes.
  Parts gather(int k) const {
    Parts c;
    for (std::size_t part = 0; part < 4; ++part) {
      for (int s = 0; s < lane_count; ++s) {
        c[part][s] = from[static_cast<std::size_t>(s)][static_cast<std::size_t>(4 * k) + part];
      }
      c[part] *= on;
    }
    return c;
  }

  std::array<const double*, lane_count> from{};
  Lanes on{}, radius{};
  ComplexLanes distance{}, inverse{};
};

double sum_of(const Lanes& lanes) {
  double sum = 0.0;
  for (int s = 0; s < lane_count; ++s) sum += lanes[s];
  return sum;
}

}  // namespace

// (08.10) for a register of source boxes at a time; `outward` is R_s / D, `inward` is -R_t / D.
void Translations::m2l(const std::vector<Box>& boxes, const Expansions& multipole,
                       std::span<const Index> list, Index field, const Box& target,
                       Eigen::Ref<Expansion> sum) const {
  if (list.empty()) return;
  const int columns = order_ + 1;
  Rows x, y, total;
  std::fill_n(total.begin(), columns, Parts{});
  for (std::size_t first = 0; first < list.size(); first += lane_count) {
    const Batch batch(boxes, multipole,
                      list.subspan(first, std::min<std::size_t>(lane_count, list.size() - first)),
                      field, target);
    const Parts logarithm = batch.gather(0);
    x[0] = logarithm;
    const ComplexLanes outward{batch.radius * batch.inverse.x, batch.radius * batch.inverse.y};
    ComplexLanes power = outward;
    for (int k = 1; k <= order_; ++k, power *= outward) {
      x[static_cast<std::size_t>(k)] = power.times(batch.gather(k));
    }
    multiply(m2l_.data(), columns, x, y);
    const ComplexLanes inward{-target.radius * batch.inverse.x, -target.radius * batch.inverse.y};
    const ComplexLanes conjugate{batch.distance.x / target.radius,
                                 -(batch.distance.y / target.radius)};
    for (std::size_t part = 0; part < 4; ++part) total[0][part] += y[0][part];
    power = inward;
    for (int l = 1; l <= order_; ++l, power *= inward) {
      const Parts moved = power.times(y[static_cast<std::size_t>(l)]);
      Parts& row = total[static_cast<std::size_t>(l)];
      for (std::size_t part = 0; part < 4; ++part) row[part] += moved[part];
      // mu_(l-1) += l lambda_l conj(D) / R_t (08.11)
      Parts& before = total[static_cast<std::size_t>(l) - 1];
      const auto factor = static_cast<double>(l);
      before[2] += factor * (conjugate.x * moved[0] - conjugate.y * moved[1]);
      before[3] += factor * (conjugate.x * moved[1] + conjugate.y * moved[0]);
    }
    // Logarithms: lambda_0 += A_0 log D, mu_0 += B_0 (log D - 1)
    for (int s = 0; s < lane_count; ++s) {
      const Complex a{logarithm[0][s], logarithm[1][s]}, b{logarithm[2][s], logarithm[3][s]};
      if (a == 0.0 && b == 0.0) continue;
      const Complex log = std::log(Complex{batch.distance.x[s], batch.distance.y[s]});
      const Complex phi = a * log, psi = b * log - b;
      sum.col(0) += Coefficients{phi.real(), phi.imag(), psi.real(), psi.imag()};
    }
  }
  for (int l = 0; l < columns; ++l) {
    const Parts& row = total[static_cast<std::size_t>(l)];
    sum.col(l) += Coefficients{sum_of(row[0]), sum_of(row[1]), sum_of(row[2]), sum_of(row[3])};
  }
}

// (08.10) and (08.11)
Eigen::MatrixXd Translations::m2l_matrix(const Box& from, const Box& to) const {
  const Complex distance = to.centre - from.centre;
  const Complex outward = from.radius / distance, inward = -to.radius / distance;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4 * (order_ + 1), 4 * (order_ + 1));
  // Adds the product with a complex number, from the part of a column's power to that of a row's.
  const auto add = [&](Index row, Index column, Complex factor) {
    matrix(row, column) += factor.real();
    matrix(row, column + 1) -= factor.imag();
    matrix(row + 1, column) += factor.imag();
    matrix(row + 1, column + 1) += factor.real();
  };
  Complex of_column = 1.0;
  for (Index k = 0; k <= order_; ++k, of_column *= outward) {
    Complex of_row = of_column;
    for (Index l = 0; l <= order_; ++l, of_row *= inward) {
      const Complex factor = m2l_(l, k) * of_row;
      add(4 * l, 4 * k, factor);          // phi to phi
      add(4 * l + 2, 4 * k + 2, factor);  // psi to psi
      if (l > 0) {
        const auto power = static_cast<double>(l);
        add(4 * l - 2, 4 * k, power * factor * std::conj(distance) / to.radius);  // phi to psi
      }
    }
  }
  add(0, 0, std::log(distance));
  add(2, 2, std::log(distance) - 1.0);
  return matrix;
}

}  // namespace stokesbook
