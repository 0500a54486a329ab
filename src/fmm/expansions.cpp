#include "fmm/expansions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stokesbook {

using Eigen::Index;

namespace {

// Eight numbers that are computed with at once, by the vector extension of GCC and Clang.
constexpr int lane_count = 8;
using Lanes = double __attribute__((vector_size(8 * lane_count)));

constexpr int most_order = 60;

// A complex number times the coefficients of both functions.
Coefficients times(Complex factor, const Coefficients& c) {
  const double x = factor.real(), y = factor.imag();
  return {x * c[0] - y * c[1], x * c[1] + y * c[0], x * c[2] - y * c[3], x * c[3] + y * c[2]};
}

// A complex number times the coefficient of phi, to be added to that of psi.
Coefficients to_psi(Complex factor, const Coefficients& c) {
  const double x = factor.real(), y = factor.imag();
  return {0.0, 0.0, x * c[0] - y * c[1], x * c[1] + y * c[0]};
}

// Below this share of the smaller box's radius a shift's powers would be unbalanced.
constexpr double least_shift = 0.02;

using Table = std::array<Coefficients, most_order + 1>;

}  // namespace

Translations::Translations(int order) : order_(order) {
  if (order < 1 || order > most_order) {
    throw std::invalid_argument("the order of an expansion must be from 1 to " +
                                std::to_string(most_order) + ", got " + std::to_string(order));
  }
  const int rows = order + 1;
  pascal_.assign(static_cast<std::size_t>(rows * rows), 0.0);
  convert_.assign(static_cast<std::size_t>(rows * order), 0.0);
  for (int n = 0; n < rows; ++n) {
    for (int k = 0; k <= n; ++k) {
      const bool edge = k == 0 || k == n;
      pascal_[static_cast<std::size_t>(n * rows + k)] =
          edge ? 1.0 : binomial(n - 1, k - 1) + binomial(n - 1, k);
    }
  }
  // binomial(k + l - 1, l) by rows: 1 for l = 0, and sums of neighbours.
  for (int l = 0; l < rows; ++l) {
    for (int k = 1; k <= order; ++k) {
      const auto at = [&](int row, int column) -> double& {
        return convert_[static_cast<std::size_t>(row * order + column - 1)];
      };
      at(l, k) = l == 0 || k == 1 ? 1.0 : at(l - 1, k) + at(l, k - 1);
    }
  }
}

double Translations::binomial(int n, int k) const {
  return pascal_[static_cast<std::size_t>(n * (order_ + 1) + k)];
}

void Translations::outgoing(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
                            Eigen::Ref<Expansion> sum) const {
  const Complex d = from.centre - to.centre;
  const bool balanced = std::abs(d) > least_shift * from.scale;
  const Complex step = d / to.scale;
  // Scaled by (R_1 / d)^k, or by (R_1 / R_2)^k where d is too small to divide by.
  const Complex ratio = balanced ? from.scale / d : Complex{from.scale / to.scale};
  Table scaled;
  Complex power = 1.0;
  for (int k = 1; k <= order_; ++k) {
    power *= ratio;
    scaled[static_cast<std::size_t>(k)] = times(power, expansion.col(k));
  }
  const Coefficients logarithm = expansion.col(0);
  sum.col(0) += logarithm;
  Coefficients previous = -logarithm;  // l A_l of the l before
  power = 1.0;
  for (int l = 1; l <= order_; ++l) {
    power *= step;
    Coefficients moved = Coefficients::Zero();
    if (balanced) {
      for (int k = 1; k <= l; ++k) {
        moved += binomial(l - 1, k - 1) * scaled[static_cast<std::size_t>(k)];
      }
      moved = times(power, moved - logarithm / l);
    } else {
      Complex shift = 1.0;
      for (int k = l; k >= 1; --k, shift *= step) {
        moved += binomial(l - 1, k - 1) * times(shift, scaled[static_cast<std::size_t>(k)]);
      }
      moved -= times(power, logarithm / l);
    }
    sum.col(l) += moved + to_psi(std::conj(step), previous);
    previous = l * moved;
  }
}

void Translations::incoming(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
                            Eigen::Ref<Expansion> sum) const {
  const Complex d = to.centre - from.centre;
  const bool balanced = std::abs(d) > least_shift * to.scale;
  const Complex step = d / from.scale;
  const Complex ratio = balanced ? to.scale / d : Complex{to.scale / from.scale};
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
        moved += binomial(l, m) * scaled[static_cast<std::size_t>(l)];
      }
    } else {
      Complex shift = 1.0;
      for (int l = m; l <= order_; ++l, shift *= step) {
        moved += binomial(l, m) * times(shift, scaled[static_cast<std::size_t>(l)]);
      }
    }
    moved = times(power, moved);
    power *= ratio;
    sum.col(m) += moved;
    if (m > 0) sum.col(m - 1) += to_psi(static_cast<double>(m) * std::conj(d) / to.scale, moved);
  }
}

namespace {

// Expansions of eight boxes on their way to one target: a row a power, both functions' real and
// imaginary parts.
struct Batch {
  std::array<std::array<Lanes, 4>, most_order + 4> rows;
};

// Y = H X, four rows at a time, so that sums stay in registers.
void multiply(const double* h, int order, const Batch& x, Batch& y) {
  for (int first = 0; first <= order; first += 4) {
    std::array<std::array<Lanes, 4>, 4> sum{};
    std::array<const double*, 4> row{};
    for (int i = 0; i < 4; ++i)
      row[static_cast<std::size_t>(i)] = h + std::min(first + i, order) * order;
    for (int k = 0; k < order; ++k) {
      const std::array<Lanes, 4>& column = x.rows[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < 4; ++i) {
        const double factor = row[i][k];
        for (std::size_t part = 0; part < 4; ++part) sum[i][part] += factor * column[part];
      }
    }
    for (std::size_t i = 0; i < 4; ++i) y.rows[static_cast<std::size_t>(first) + i] = sum[i];
  }
}

struct ComplexLanes {
  Lanes x, y;

  void operator*=(const ComplexLanes& other) {
    const Lanes real = x * other.x - y * other.y;
    y = x * other.y + y * other.x;
    x = real;
  }
};

}  // namespace

void Translations::convert(const std::vector<Box>& sources, const Expansion& outgoing,
                           std::span<const Index> list, const Box& target,
                           Eigen::Ref<Expansion> sum) const {
  Batch x, y, total{};
  const Index columns = order_ + 1;
  for (std::size_t begin = 0; begin < list.size(); begin += lane_count) {
    const std::size_t count = std::min<std::size_t>(lane_count, list.size() - begin);
    std::array<const double*, lane_count> from{};
    std::array<double, lane_count> on{};  // 0 for lanes beyond the list, which repeat its last box
    ComplexLanes outward{}, inward{}, conjugate{}, distance{};
    for (int s = 0; s < lane_count; ++s) {
      const auto lane = static_cast<std::size_t>(s);
      const Index box = list[begin + std::min(lane, count - 1)];
      const Box& source = sources[static_cast<std::size_t>(box)];
      const Complex d = target.centre - source.centre;
      const Complex out = source.scale / d, in = -target.scale / d;
      from[lane] = outgoing.data() + 4 * columns * box;
      on[lane] = lane < count ? 1.0 : 0.0;
      outward.x[s] = out.real();
      outward.y[s] = out.imag();
      inward.x[s] = in.real();
      inward.y[s] = in.imag();
      conjugate.x[s] = d.real() / target.scale;
      conjugate.y[s] = -d.imag() / target.scale;
      distance.x[s] = d.real();
      distance.y[s] = d.imag();
    }
    const auto gather = [&](int k) {
      std::array<Lanes, 4> c;
      for (std::size_t part = 0; part < 4; ++part) {
        for (int s = 0; s < lane_count; ++s) {
          const auto lane = static_cast<std::size_t>(s);
          c[part][s] = on[lane] * from[lane][static_cast<std::size_t>(4 * k) + part];
        }
      }
      return c;
    };
    ComplexLanes power{outward};
    for (int k = 1; k <= order_; ++k, power *= outward) {
      const std::array<Lanes, 4> c = gather(k);
      x.rows[static_cast<std::size_t>(k) - 1] = {
          power.x * c[0] - power.y * c[1], power.x * c[1] + power.y * c[0],
          power.x * c[2] - power.y * c[3], power.x * c[3] + power.y * c[2]};
    }
    multiply(convert_.data(), order_, x, y);
    const std::array<Lanes, 4> logarithm = gather(0);
    power = {Lanes{} + 1.0, Lanes{}};
    for (int l = 0; l <= order_; ++l, power *= inward) {
      std::array<Lanes, 4> c = y.rows[static_cast<std::size_t>(l)];
      if (l > 0) {
        for (std::size_t part = 0; part < 4; ++part) c[part] -= logarithm[part] / double(l);
      }
      const std::array<Lanes, 4> moved{
          power.x * c[0] - power.y * c[1], power.x * c[1] + power.y * c[0],
          power.x * c[2] - power.y * c[3], power.x * c[3] + power.y * c[2]};
      std::array<Lanes, 4>& row = total.rows[static_cast<std::size_t>(l)];
      for (std::size_t part = 0; part < 4; ++part) row[part] += moved[part];
      if (l > 0) {
        std::array<Lanes, 4>& before = total.rows[static_cast<std::size_t>(l) - 1];
        const auto factor = static_cast<double>(l);
        before[2] += factor * (conjugate.x * moved[0] - conjugate.y * moved[1]);
        before[3] += factor * (conjugate.x * moved[1] + conjugate.y * moved[0]);
      }
    }
    for (int s = 0; s < lane_count; ++s) {
      const Complex a{logarithm[0][s], logarithm[1][s]}, b{logarithm[2][s], logarithm[3][s]};
      if (a == 0.0 && b == 0.0) continue;
      const Complex log = std::log(Complex{distance.x[s], distance.y[s]});
      const Complex phi = a * log, psi = b * log - b;
      sum.col(0) += Coefficients{phi.real(), phi.imag(), psi.real(), psi.imag()};
    }
  }
  for (int l = 0; l <= order_; ++l) {
    for (std::size_t part = 0; part < 4; ++part) {
      const Lanes& lanes = total.rows[static_cast<std::size_t>(l)][part];
      double value = 0.0;
      for (int s = 0; s < lane_count; ++s) value += lanes[s];
      sum(static_cast<Index>(part), l) += value;
    }
  }
}

void add_outgoing(const Box& box, const StressletSources& sources, Eigen::Ref<Expansion> sum) {
  constexpr Index chunk = 64;
  std::array<double, chunk> wx, wy, gx, gy, px, py, qx, qy;
  const double inverse = 1.0 / box.scale;
  for (Index first = box.first; first < box.last; first += chunk) {
    const Index count = std::min(chunk, box.last - first);
    const double *ax = &sources.ax[first], *ay = &sources.ay[first], *b = &sources.b[first];
    for (Index i = 0; i < count; ++i) {
      const auto j = static_cast<std::size_t>(i);
      wx[j] = (sources.x[first + i] - box.centre.real()) * inverse;
      wy[j] = (sources.y[first + i] - box.centre.imag()) * inverse;
      // a conj(W)
      gx[j] = ax[i] * wx[j] + ay[i] * wy[j];
      gy[j] = ay[i] * wx[j] - ax[i] * wy[j];
      px[j] = 1.0;  // W^(k-1)
      py[j] = 0.0;
      qx[j] = 0.0;  // W^(k-2)
      qy[j] = 0.0;
    }
    for (Index k = 1; k < sum.cols(); ++k) {
      const auto factor = static_cast<double>(k - 1);
      double phi_x = 0.0, phi_y = 0.0, psi_x = 0.0, psi_y = 0.0;
#pragma omp simd reduction(+ : phi_x, phi_y, psi_x, psi_y)
      for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) {
        phi_x += ax[j] * px[j] - ay[j] * py[j];
        phi_y += ax[j] * py[j] + ay[j] * px[j];
        psi_x += factor * (gx[j] * qx[j] - gy[j] * qy[j]) - b[j] * px[j];
        psi_y += factor * (gx[j] * qy[j] + gy[j] * qx[j]) - b[j] * py[j];
        qx[j] = px[j];
        qy[j] = py[j];
        px[j] = qx[j] * wx[j] - qy[j] * wy[j];
        py[j] = qx[j] * wy[j] + qy[j] * wx[j];
      }
      sum.col(k) += inverse * Coefficients{phi_x, phi_y, psi_x, psi_y};
    }
  }
}

void add_outgoing(const Box& box, const SingularitySources& sources, Eigen::Ref<Expansion> sum) {
  const auto coefficients = [](Complex phi, Complex psi) {
    return Coefficients{phi.real(), phi.imag(), psi.real(), psi.imag()};
  };
  for (Index i = box.first; i < box.last; ++i) {
    const Complex f = sources.force[i];
    const Complex w = (sources.position[i] - box.centre) / box.scale;
    const Complex rotlet = imaginary * sources.torque[i] / box.scale;
    sum.col(0) += coefficients(-0.5 * f, 0.5 * std::conj(f));
    Complex power = 1.0;  // W^(k-1)
    for (Index k = 1; k < sum.cols(); ++k) {
      const double half = 0.5 / static_cast<double>(k);
      sum.col(k) += coefficients(half * f * power * w, (0.5 * std::conj(w) * f + rotlet) * power -
                                                           half * std::conj(f) * power * w);
      power *= w;
    }
  }
}

void add_velocity(const Box& box, Eigen::Ref<const Expansion> expansion,
                  const ComplexVector& points, Eigen::Ref<ComplexVector> sum) {
  const double inverse = 1.0 / box.scale;
  for (Index first = box.first; first < box.last; first += lane_count) {
    const int count = static_cast<int>(std::min<Index>(lane_count, box.last - first));
    ComplexLanes w{}, phi{}, dphi{}, psi{};
    for (int s = 0; s < count; ++s) {
      w.x[s] = (points[first + s].real() - box.centre.real()) * inverse;
      w.y[s] = (points[first + s].imag() - box.centre.imag()) * inverse;
    }
    // Horner's rule for phi and psi, and for phi' with what phi was before.
    for (Index l = expansion.cols() - 1; l >= 0; --l) {
      dphi *= w;
      dphi.x += phi.x;
      dphi.y += phi.y;
      phi *= w;
      phi.x += expansion(0, l);
      phi.y += expansion(1, l);
      psi *= w;
      psi.x += expansion(2, l);
      psi.y += expansion(3, l);
    }
    // u = phi - w conj(dphi/dw) - conj(psi)
    const Lanes u = phi.x - (w.x * dphi.x + w.y * dphi.y) - psi.x;
    const Lanes v = phi.y - (w.y * dphi.x - w.x * dphi.y) + psi.y;
    for (int s = 0; s < count; ++s) sum[first + s] += Complex{u[s], v[s]};
  }
}

FlowDerivatives derivatives(const Box& box, Eigen::Ref<const Expansion> expansion, Complex z) {
  const Complex w = (z - box.centre) / box.scale;
  Complex phi{}, dphi{}, ddphi{}, psi{}, dpsi{};
  for (Index l = expansion.cols() - 1; l >= 0; --l) {
    ddphi = ddphi * w + 2.0 * dphi;
    dphi = dphi * w + phi;
    phi = phi * w + Complex{expansion(0, l), expansion(1, l)};
    dpsi = dpsi * w + psi;
    psi = psi * w + Complex{expansion(2, l), expansion(3, l)};
  }
  const Complex slope = dphi / box.scale;
  const Complex conjugate = (std::conj(w) * ddphi + dpsi) / box.scale;
  return {-4.0 * slope.real(), 4.0 * slope.imag(), -2.0 * std::conj(conjugate)};
}

}  // namespace stokesbook
