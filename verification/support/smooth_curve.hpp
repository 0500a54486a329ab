#pragma once

#include <memory>

#include "near_singular/closest_points.hpp"

namespace stokesbook::test {

/// Places a curve, which is given in its own frame, in the plane. The parametrisation interpolates
/// the nodes of the curve.
inline SmoothCurve smooth_curve(const Curve& reference, Complex position, double orientation) {
  return {place(reference, position, orientation),
          std::make_shared<const Parametrisation>(TrigonometricPolynomial(reference.x)), position,
          orientation};
}

inline SmoothCurve smooth_curve(const Shape& shape, Eigen::Index n, Side side, Complex position,
                                double orientation) {
  return {place(sample(shape, n, side), position, orientation),
          std::make_shared<const Parametrisation>(parametrisation(shape)), position, orientation};
}

inline SmoothCurve smooth_body(const Shape& shape, Eigen::Index n, Complex position,
                               double orientation) {
  return smooth_curve(shape, n, Side::fluid_outside, position, orientation);
}

}  // namespace stokesbook::test
