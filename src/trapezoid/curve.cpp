// Samples shapes at equidistant or graded nodes, and places curves in the plane. Computes weights
// (01.2), normals (01.3), curvatures (01.4), lengths and areas of curves from their nodes, by the
// periodic trapezoid rule.
#include "trapezoid/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trapezoid/fourier.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

Curve sample(const Shape& shape, Index n, Side side, const Grading& grading) {
  require(n >= 4 && n % 2 == 0, "a curve requires an even number of nodes >= 4, got ", n);
  const std::vector<GradedParameter> parameters = graded_parameters(grading, n);
  const auto* nodal = std::get_if<NodalCurve>(&shape);
  if (nodal == nullptr || !grading.clusters.empty()) return sample(shape, parameters, side);
  // At equidistant parameters, fast Fourier transforms replace the sums of modes.
  const ComplexVector x = resample(counter_clockwise(*nodal), n);
  const ComplexVector dx = differentiate(x);
  return {x, dx, differentiate(dx), side};
}

// x(t(s)), dx/ds = x' t' and d2x/ds2 = x'' t'^2 + x' t'', t' and t'' being derivatives in s.
Curve sample(const Shape& shape, const std::vector<GradedParameter>& parameters, Side side) {
  const Parametrisation point = parametrisation(shape);
  const auto n = static_cast<Index>(parameters.size());
  Curve curve{ComplexVector(n), ComplexVector(n), ComplexVector(n), side};
  for (Index j = 0; j < n; ++j) {
    const auto [t, dt, ddt] = parameters[static_cast<std::size_t>(j)];
    const auto [x, first, second] = point(t);
    curve.x[j] = x;
    curve.dx[j] = first * dt;
    curve.ddx[j] = second * (dt * dt) + first * ddt;
  }
  return curve;
}

Curve resample(const Curve& curve, Index m) {
  return {resample(curve.x, m), resample(curve.dx, m), resample(curve.ddx, m), curve.side};
}

Curve place(const Curve& reference, Complex position, double orientation) {
  // x -> c + e^{i theta} x; the derivatives are only turned.
  const Complex turn = std::polar(1.0, orientation);
  return {(position + (turn * reference.x).array()).matrix(), turn * reference.dx,
          turn * reference.ddx, reference.side};
}

ComplexVector all_nodes(const std::vector<Curve>& curves) {
  std::vector<Complex> nodes;
  for (const Curve& curve : curves) nodes.insert(nodes.end(), curve.x.begin(), curve.x.end());
  return ComplexVector::Map(nodes.data(), std::ssize(nodes));
}

Eigen::VectorXd weights(const Curve& curve) {
  // w_j = |x'(t_j)| 2 pi / N (01.2).
  return curve.dx.cwiseAbs() * (2.0 * std::numbers::pi / static_cast<double>(curve.size()));
}

ComplexVector normals(const Curve& curve) {
  // n = -i s x' / |x'| (01.3).
  return (-imaginary * curve.sign()) * curve.dx.cwiseQuotient(curve.dx.cwiseAbs());
}

Eigen::VectorXd curvatures(const Curve& curve) {
  // kappa = (x' cross x'') / |x'|^3 (01.4).
  const auto cross_product = (curve.dx.conjugate().array() * curve.ddx.array()).imag();
  return cross_product / curve.dx.array().abs().cube();
}

double perimeter(const Curve& curve) {
  return weights(curve).sum();
}

double area(const Curve& curve) {
  // (1 / 2) sum_j (x_j cross x'_j) 2 pi / N.
  return (curve.x.conjugate().array() * curve.dx.array()).imag().sum() * std::numbers::pi /
         static_cast<double>(curve.size());
}

Complex boundary_centroid(const Curve& curve) {
  const Eigen::VectorXd w = weights(curve);
  return curve.x.cwiseProduct(w).sum() / w.sum();
}

double bounding_radius(const Curve& curve, Complex centre) {
  return (curve.x.array() - centre).abs().maxCoeff();
}

double outer_radius(const Curve& curve, Complex centre) {
  // The squared distance g = |x - c|^2 has the derivatives g' = 2 (x - c).x' and
  // g'' = 2 |x'|^2 + 2 (x - c).x''.
  const Index n = curve.size();
  const double half_spacing = std::numbers::pi / static_cast<double>(n);
  const Eigen::ArrayXcd arm = curve.x.array() - centre;
  const Eigen::ArrayXd slope = 2.0 * (arm.conjugate() * curve.dx.array()).real().abs();
  const Eigen::ArrayXd bend =
      2.0 * (curve.dx.array().abs2() + (arm.conjugate() * curve.ddx.array()).real());
  double radius = 0.0;
  for (Index j = 0; j < n; ++j) {
    // The largest value of g_j + |g'_j| tau + M tau^2 / 2 over 0 <= tau <= pi / N.
    const double most = std::max({bend[(j + n - 1) % n], bend[j], bend[(j + 1) % n]});
    const double step = most < 0.0 ? std::min(half_spacing, slope[j] / -most) : half_spacing;
    const double rise = step * (slope[j] + 0.5 * most * step), own = std::abs(arm[j]);
    // sqrt(own^2 + rise), in a form that returns exactly `own` if rise = 0.
    radius = std::max(radius, own + rise / (own + std::sqrt(own * own + rise)));
  }
  return radius;
}

}  // namespace stokesbook
