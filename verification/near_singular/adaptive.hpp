#pragma once

#include "trapezoid/curve.hpp"

namespace stokesbook::verification::near_singular {

/// Holds the result of an adaptive quadrature.
struct AdaptiveResult {
  Complex velocity;
  Eigen::Index evaluations;  ///< kernel evaluations
  bool content;              ///< whether the quadrature reports that its tolerance is met
};

/// Evaluates the double layer at a point by GSL's adaptive Gauss-Kronrod rule. The integrand
/// consists of the interpolants of curve and density; the interval is divided at the closest point.
/// The function is independent of every method of the book.
///
/// @param  tolerance  absolute and relative, of each component
AdaptiveResult adaptive_velocity(const Curve& curve, const ComplexVector& density, Complex target,
                                 double tolerance);

}  // namespace stokesbook::verification::near_singular
