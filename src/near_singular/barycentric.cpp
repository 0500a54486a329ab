// Evaluates Cauchy integrals on the fluid's side of a curve by the compensated barycentric formula
// (06.14), their limits on the curve by (06.11), and distinguishes the sides of the curve by the
// formula's divisor (06.15).
#include "near_singular/barycentric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Sums over the nodes for one target, before the division by Delta (06.14).
struct Sums {
  Complex delta, first, second;

  bool finite() const { return std::isfinite(std::norm(delta)); }
  BarycentricValues values() const { return {first / delta, second / delta}; }
};

struct Nodes {
  const double *x, *y, *cx, *cy;
  Index size;
  double own;
};

// Real and imaginary parts of f, g and h at the nodes, in separate vectors.
struct Functions {
  Eigen::VectorXd fx, fy, gx, gy, hx, hy;
};

// Computes the sums for two targets at once. Both targets share one division per node, because the
// divisions limit the speed of the loop.
void add_up(const Nodes& nodes, const Functions& functions, Complex target_0, Complex target_1,
            Sums& sums_0, Sums& sums_1) {
  const double x0 = target_0.real(), y0 = target_0.imag();
  const double x1 = target_1.real(), y1 = target_1.imag();
  const double *x = nodes.x, *y = nodes.y, *cx = nodes.cx, *cy = nodes.cy;
  const double *fx = functions.fx.data(), *fy = functions.fy.data();
  const double *gx = functions.gx.data(), *gy = functions.gy.data();
  const double *hx = functions.hx.data(), *hy = functions.hy.data();
  const Index size = nodes.size;
  double dx0 = nodes.own, dy0 = 0.0, ax0 = 0.0, ay0 = 0.0, bx0 = 0.0, by0 = 0.0;
  double dx1 = nodes.own, dy1 = 0.0, ax1 = 0.0, ay1 = 0.0, bx1 = 0.0, by1 = 0.0;
#pragma omp simd reduction(+ : dx0, dy0, ax0, ay0, bx0, by0, dx1, dy1, ax1, ay1, bx1, by1)
  for (Index j = 0; j < size; ++j) {
    const double rx0 = x0 - x[j], ry0 = y0 - y[j];
    const double rx1 = x1 - x[j], ry1 = y1 - y[j];
    const double rho2_0 = rx0 * rx0 + ry0 * ry0, rho2_1 = rx1 * rx1 + ry1 * ry1;
    const double inverse = -1.0 / (rho2_0 * rho2_1);
    // W = c / (t - z) = -c conj(r) / rho^2 with r = z - t; i0 = -1 / rho2_0, i1 = -1 / rho2_1
    const double i0 = inverse * rho2_1, i1 = inverse * rho2_0;
    const double wx0 = (cx[j] * rx0 + cy[j] * ry0) * i0, wy0 = (cy[j] * rx0 - cx[j] * ry0) * i0;
    const double wx1 = (cx[j] * rx1 + cy[j] * ry1) * i1, wy1 = (cy[j] * rx1 - cx[j] * ry1) * i1;
    dx0 += wx0;
    dy0 += wy0;
    dx1 += wx1;
    dy1 += wy1;
    ax0 += wx0 * fx[j] - wy0 * fy[j];
    ay0 += wx0 * fy[j] + wy0 * fx[j];
    ax1 += wx1 * fx[j] - wy1 * fy[j];
    ay1 += wx1 * fy[j] + wy1 * fx[j];
    // g + (conj(z) - conj(t)) h
    const double sx0 = gx[j] + rx0 * hx[j] + ry0 * hy[j], sy0 = gy[j] + rx0 * hy[j] - ry0 * hx[j];
    const double sx1 = gx[j] + rx1 * hx[j] + ry1 * hy[j], sy1 = gy[j] + rx1 * hy[j] - ry1 * hx[j];
    bx0 += wx0 * sx0 - wy0 * sy0;
    by0 += wx0 * sy0 + wy0 * sx0;
    bx1 += wx1 * sx1 - wy1 * sy1;
    by1 += wx1 * sy1 + wy1 * sx1;
  }
  sums_0 = {{dx0, dy0}, {ax0, ay0}, {bx0, by0}};
  sums_1 = {{dx1, dy1}, {ax1, ay1}, {bx1, by1}};
}

}  // namespace

Barycentric::Barycentric(const Curve& curve)
    : x_(curve.x.real()), y_(curve.x.imag()), own_(curve.side == Side::fluid_outside ? 1.0 : 0.0) {
  // c_j = s t'_j h / (2 pi i) with h = 2 pi / N
  const ComplexVector c =
      curve.dx * (curve.sign() / (imaginary * static_cast<double>(curve.size())));
  cx_ = c.real();
  cy_ = c.imag();
}

Index Barycentric::node_at(Complex target) const {
  Index nearest = 0;
  ((x_.array() - target.real()).square() + (y_.array() - target.imag()).square())
      .minCoeff(&nearest);
  return nearest;
}

std::vector<BarycentricValues> Barycentric::operator()(const Eigen::Ref<const ComplexVector>& f,
                                                       const Eigen::Ref<const ComplexVector>& g,
                                                       const Eigen::Ref<const ComplexVector>& h,
                                                       const ComplexVector& targets) const {
  const Functions functions{f.real(), f.imag(), g.real(), g.imag(), h.real(), h.imag()};
  const Nodes nodes{x_.data(), y_.data(), cx_.data(), cy_.data(), size(), own_};
  const Index m = targets.size();
  std::vector<BarycentricValues> values(static_cast<std::size_t>(m));
  const auto store = [&](Index i, const Sums& sums) {
    BarycentricValues& value = values[static_cast<std::size_t>(i)];
    if (sums.finite()) {
      value = sums.values();
    } else {
      // The target is a node, or so close to one that rho^2 underflows.
      const Index k = node_at(targets[i]);
      value = {f[k], g[k]};
    }
  };
  for (Index i = 0; i < m; i += 2) {
    const Index partner = std::min(i + 1, m - 1);
    Sums sums, sums_of_partner;
    add_up(nodes, functions, targets[i], targets[partner], sums, sums_of_partner);
    if (!sums.finite() || !sums_of_partner.finite()) {
      // One of the targets is a node, which makes the shared quotient infinite for both targets:
      // repeat the sums with each target alone.
      add_up(nodes, functions, targets[i], targets[i], sums, sums);
      add_up(nodes, functions, targets[partner], targets[partner], sums_of_partner,
             sums_of_partner);
    }
    store(i, sums);
    store(partner, sums_of_partner);
  }
  return values;
}

// (C+[f])_j = [s=+1] f_j + sum_k (f_k - f_j) c_k / (x_k - x_j) + f'_j s h / (2 pi i), where the
// term k = j of the sum vanishes (06.11).
ComplexVector Barycentric::limits(const ComplexVector& f) const {
  const Index n = size();
  const Eigen::VectorXd real = f.real(), imag = f.imag();
  const double *x = x_.data(), *y = y_.data(), *cx = cx_.data(), *cy = cy_.data();
  const double *fx = real.data(), *fy = imag.data();
  const double sign = own_ == 1.0 ? -1.0 : 1.0;
  ComplexVector result = differentiate(f) * (sign / (imaginary * static_cast<double>(n)));
  for (Index j = 0; j < n; ++j) {
    const double xj = x[j], yj = y[j], fxj = fx[j], fyj = fy[j];
    double sum_x = 0.0, sum_y = 0.0;
#pragma omp simd reduction(+ : sum_x, sum_y)
    for (Index k = 0; k < n; ++k) {
      const double rx = x[k] - xj, ry = y[k] - yj;
      const double inverse = 1.0 / std::max(rx * rx + ry * ry, std::numeric_limits<double>::min());
      // c / (x_k - x_j) = c conj(r) / rho^2 with r = x_k - x_j
      const double wx = (cx[k] * rx + cy[k] * ry) * inverse;
      const double wy = (cy[k] * rx - cx[k] * ry) * inverse;
      const double gx = fx[k] - fxj, gy = fy[k] - fyj;
      sum_x += wx * gx - wy * gy;
      sum_y += wx * gy + wy * gx;
    }
    result[j] += Complex{sum_x, sum_y} + (1.0 - own_) * f[j];
  }
  return result;
}

Eigen::MatrixXcd Barycentric::weights(const ComplexVector& targets) const {
  // w_j = W_j / Delta with Delta = sum_j W_j + [s = -1] (06.14); on a node w = 1 there, else 0.
  Eigen::MatrixXcd result(targets.size(), size());
  for (Index i = 0; i < targets.size(); ++i) {
    Complex delta = own_;
    for (Index j = 0; j < size(); ++j) {
      result(i, j) = Complex{cx_[j], cy_[j]} / (Complex{x_[j], y_[j]} - targets[i]);
      delta += result(i, j);
    }
    if (std::isfinite(std::norm(delta))) {
      result.row(i) /= delta;
    } else {
      result.row(i).setZero();
      result(i, node_at(targets[i])) = 1.0;
    }
  }
  return result;
}

double Barycentric::side(Complex point) const {
  // Re Delta = [s = -1] + sum_j Re W_j
  double re = own_;
  for (Index j = 0; j < size(); ++j) {
    const double rx = point.real() - x_[j], ry = point.imag() - y_[j];
    const double rho2 = rx * rx + ry * ry;
    if (rho2 == 0.0) return std::numeric_limits<double>::infinity();
    re -= (cx_[j] * rx + cy_[j] * ry) / rho2;
  }
  return re;
}

}  // namespace stokesbook
