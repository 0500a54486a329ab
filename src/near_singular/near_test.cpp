#include "near_singular/near_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stokesbook {

using Eigen::Index;

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
  Complex sum{};
  for (Index j = 0; j < curve.size(); j += 2) {
    sum += curve.dx[j] / (curve.x[j] - target);
  }
  const Complex value = 2.0 * sum / (imaginary * static_cast<double>(curve.size()));
  // 1 inside the curve and 0 outside; where the rule errs so much that this is in doubt, either
  // error is at least 1/2. On a node it is no number.
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
  // The least positive number stands for none, which the quotient would not bear.
  const Eigen::ArrayXd growth =
      (curve.ddx.cwiseAbs().array() / speed).max(std::numeric_limits<double>::min());
  return (speed * (s * growth).expm1() / growth).maxCoeff();
}

}  // namespace stokesbook
