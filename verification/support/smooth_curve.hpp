#pragma once

#include <memory>

#include "near_singular/closest_points.hpp"

namespace stokesbook::test {

/// Nodes in their own frame with their interpolant, placed in the plane.
inline SmoothCurve smooth_curve(const Curve& reference, Complex position, double orientation) {
  return {place(reference, position, orientation),
          std::make_shared<TrigonometricPolynomial>(reference.x), position, orientation};
}

inline SmoothCurve smooth_curve(const Shape& shape, Eigen::Index n, Side side, Complex position,
                                double orientation) {
  return smooth_curve(sample(shape, n, side), position, orientation);
}

inline SmoothCurve smooth_body(const Shape& shape, Eigen::Index n, Complex position,
                               double orientation) {
  return smooth_curve(shape, n, Side::fluid_outside, position, orientation);
}

}  // namespace stokesbook::test
