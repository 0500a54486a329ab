#pragma once

#include "trapezoid/curve.hpp"

namespace stokesbook::verification::near_singular {

/// What an adaptive quadrature found.
struct AdaptiveResult {
  Complex velocity;
  Eigen::Index evaluations;  ///< of the kernel
  bool content;              ///< it reports that its tolerance is met
};

/// The double layer at a point by GSL's adaptive Gauss-Kronrod rule, of the interpolants of curve
/// and density, on both sides of the closest node: independent of every method of the book.
///
/// @param  tolerance  absolute and relative, of each component
AdaptiveResult adaptive_velocity(const Curve& curve, const ComplexVector& density, Complex target,
                                 double tolerance);

}  // namespace stokesbook::verification::near_singular
