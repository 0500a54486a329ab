#include "near_singular/near_test.hpp"

#include <cmath>
#include <numbers>

namespace stokesbook {

Complex preimage(const Curve& curve, Eigen::Index node, Complex target) {
  const Complex d = target - curve.x[node];
  const Complex slope = curve.dx[node];
  return 2.0 * d / (slope * (1.0 + std::sqrt(1.0 + 2.0 * curve.ddx[node] * d / (slope * slope))));
}

Eigen::Index nearest_node(const Curve& curve, Complex target) {
  Eigen::Index nearest = 0;
  (curve.x.array() - target).abs2().minCoeff(&nearest);
  return nearest;
}

double near_cut(double tolerance) {
  return std::log(200.0 / tolerance);
}

bool is_near(const Curve& curve, Complex target, double tolerance) {
  const Complex s = preimage(curve, nearest_node(curve, target), target);
  return static_cast<double>(curve.size()) * std::abs(s.imag()) < near_cut(tolerance);
}

double near_reach(const Curve& curve, double tolerance) {
  const double s =
      std::hypot(near_cut(tolerance), std::numbers::pi) / static_cast<double>(curve.size());
  return (s * curve.dx.cwiseAbs() + 0.5 * s * s * curve.ddx.cwiseAbs()).maxCoeff();
}

}  // namespace stokesbook
