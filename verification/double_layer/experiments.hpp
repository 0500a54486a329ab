#pragma once

#include <cmath>
#include <vector>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "study/study.hpp"
#include "support/exact_flows.hpp"
#include "support/over_nodes.hpp"
#include "support/plain_rule.hpp"
#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::verification::double_layer {

using test::plain_rule;

/// @name Experiments of the study
/// @{
study::Experiment published_table();
study::Experiment rates_near_the_curve();
study::Experiment spacings();
study::Experiment jumps();
study::Experiment identities();
study::Experiment diagonal();
study::Experiment green();
study::Experiment dirichlet();
study::Experiment completion();
study::Experiment conditioning();
study::Experiment cost();
study::Experiment near_target();
/// @}

/// Most experiments use this shape.
inline constexpr Ellipse two_to_one{2.0, 1.0};

/// The sources of this flow in the ellipse are so far away that 96 nodes resolve the flow's density
/// to rounding.
inline const test::ExactFlow far_flow{
    {{{4.0, 3.0}, {0.5, -0.3}, 0.4}, {{-5.0, 2.0}, {0.1, 0.8}, -0.1}}, 0.7};

/// Returns the point x(t) = a cos t + i b sin t of the continuation of an ellipse to complex
/// parameters t.
///
/// For small |Im t| the point lies inside the ellipse if Im t > 0, outside if Im t < 0.
inline Complex continued(const Ellipse& ellipse, Complex t) {
  return ellipse.a * std::cos(t) + imaginary * ellipse.b * std::sin(t);
}

/// Returns sixteen points round the ellipse whose preimages have the imaginary part `height`. The
/// points are inside for height > 0.
inline ComplexVector points_at(const Ellipse& ellipse, double height) {
  ComplexVector points(16);
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    points[k] = continued(ellipse, Complex{0.4 * static_cast<double>(k) + 0.13, height});
  }
  return points;
}

/// Returns ln(1/m), m = (a - b) / (a + b), a > b: the distance from the real axis at which the
/// kernel of an ellipse on itself is singular, because x(t) = x(s) also if e^{i (t + s)} = m.
inline double kernel_distance(const Ellipse& ellipse) {
  return std::log((ellipse.a + ellipse.b) / (ellipse.a - ellipse.b));
}

/// A planted defect: the diagonal has the opposite sign of the curvature.
inline Eigen::MatrixXd with_wrong_diagonal(const Curve& curve) {
  Eigen::MatrixXd layer = double_layer_matrix(curve);
  for (Eigen::Index j = 0; j < curve.size(); ++j) layer.block<2, 2>(2 * j, 2 * j) *= -1.0;
  return layer;
}

/// Returns the largest error, relative to the largest exact value.
inline double relative_error(const ComplexVector& got, const ComplexVector& exact) {
  return test::largest(got - exact) / test::largest(exact);
}

/// Measures an error, a function of the number of nodes, at node counts for which e^{-rate n}
/// decreases from 1 to rounding.
template <class Error>
study::Measure errors_at(double rate, const Error& error) {
  return test::over_nodes(0.0, 36.0 / rate, 24, error, 2.0);
}

}  // namespace stokesbook::verification::double_layer
