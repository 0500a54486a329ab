#pragma once

#include <cmath>
#include <numbers>

#include "trapezoid/shape.hpp"

namespace stokesbook::test {

/// Samples the curve r = 1 + .2 cos 2t + .15 cos(3t + 1), multiplied by a length. The curve has no
/// symmetry, and its centroid is not the origin.
inline NodalCurve lopsided_curve(double length = 1.0) {
  NodalCurve shape{ComplexVector(16), {}};
  for (Eigen::Index j = 0; j < 16; ++j) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(j) / 16.0;
    const double r = length * (1.0 + 0.2 * std::cos(2 * t) + 0.15 * std::cos(3 * t + 1));
    shape.points[j] = std::polar(r, t);
  }
  return shape;
}

}  // namespace stokesbook::test
