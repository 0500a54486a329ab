#pragma once

#include "double_layer/kernels.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::test {

/// Evaluates the double layer by the trapezoid rule. Unlike StressletSum, the function does not
/// bound small distances from below.
inline ComplexVector plain_rule(const Curve& curve, const ComplexVector& density,
                                const ComplexVector& targets) {
  const Eigen::VectorXd w = weights(curve);
  const ComplexVector normal = normals(curve);
  return targets.unaryExpr([&](Complex target) {
    Complex velocity{};
    for (Eigen::Index j = 0; j < curve.size(); ++j) {
      velocity += w[j] * stresslet(target - curve.x[j], normal[j], density[j]);
    }
    return velocity;
  });
}

/// Rescales a density so that a quadrature rule has the effect of equal weights at all nodes, as if
/// the nodes were equidistant along the curve. The function is a planted defect.
inline ComplexVector with_equal_weights(const Curve& curve, const ComplexVector& density) {
  const double mean = perimeter(curve) / static_cast<double>(curve.size());
  return mean * density.cwiseQuotient(weights(curve));
}

}  // namespace stokesbook::test
