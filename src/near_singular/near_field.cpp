// Decides at which targets the trapezoid rule of a curve is too coarse (06.5), from the error of
// the rule for a Cauchy integral with a known value (06.2). Expands preimages of targets (06.4).
#include "near_singular/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stokesbook {

using Eigen::Index;

// Solves x_j + x'_j s + x''_j s^2 / 2 = z for its small root s (06.4).
Complex preimage(const Curve& curve, Index node, Complex target) {
  const Complex d = target - curve.x[node];
  const Complex slope = curve.dx[node];
  return 2.0 * d / (slope * (1.0 + std::sqrt(1.0 + 2.0 * curve.ddx[node] * d / (slope * slope))));
}

Index nearest_node(const Curve& curve, Complex target) {
  Index nearest = 0;
  (curve.x.array() - target).abs2().minCoeff(&nearest);
  return nearest;
}

double near_cut(double tolerance) {
  return std::log(200.0 / tolerance);
}

double preimage_depth(const Curve& curve, Complex target) {
  // The Cauchy integral of 1, (06.9) with s = 1, by the rule with every second node
  Complex sum{};
  for (Index j = 0; j < curve.size(); j += 2) {
    // By real numbers: the division of complex ones takes longer, to be safe at all sizes.
    const Complex from_target = curve.x[j] - target;
    sum += curve.dx[j] * std::conj(from_target) / std::norm(from_target);
  }
  const Complex value = 2.0 * sum / (imaginary * static_cast<double>(curve.size()));
  // The exact value is 1 inside the curve and 0 outside. If the error is so large that the side is
  // in doubt, then both differences are at least 1/2. On a node of this rule the value is not
  // finite.
  const double error = std::min(std::abs(value), std::abs(value - 1.0));
  return error < 1.0 ? -2.0 * std::log(error) : 0.0;
}

bool is_near(const Curve& curve, Complex target, double tolerance) {
  return preimage_depth(curve, target) <= near_cut(tolerance);
}

double near_reach(const Curve& curve, double tolerance) {
  const double s =
      std::hypot(near_cut(tolerance), std::numbers::pi) / static_cast<double>(curve.size());
  const Eigen::ArrayXd speed = curve.dx.cwiseAbs();
  // Clamped away from zero: straight pieces would divide by zero.
  const Eigen::ArrayXd growth =
      (curve.ddx.cwiseAbs().array() / speed).max(std::numeric_limits<double>::min());
  return (speed * (s * growth).expm1() / growth).maxCoeff();
}

}  // namespace stokesbook
