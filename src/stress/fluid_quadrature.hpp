#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Points and weights of a quadrature rule over an area.
struct FluidQuadrature {
  ComplexVector points;     ///< m points, length
  Eigen::VectorXd weights;  ///< m weights, > 0, length^2
};

/// Chooses the width of the strips of fluid_quadrature(): half of the smallest gap, but at most
/// half of the smallest radius of curvature among points whose centre of curvature lies on the
/// fluid's side.
double strip_width(const std::vector<Curve>& curves);

/// Makes a quadrature rule for smooth functions on the fluid between bodies and an enclosing wall.
///
/// In a strip of width \f$ \delta \f$ along each curve the points are \f$ x(t) - d\,n(t) \f$, by
/// the trapezoid rule in t and Gauss's rule in d. The integrand f is multiplied there by a cut-off
/// \f$ \chi(d/\delta) = \frac12\mathrm{erfc}(\beta(2d/\delta-1)) \f$, which falls from 1 on the
/// curve to 0 at the other edge of the strip (07.12). The rest \f$ (1-\sum\chi)f \f$, extended by
/// zero, is smooth in the whole plane up to rounding. Sums of this rest over a square grid converge
/// faster than any power of the spacing (07.13).
/// @param  curves            bodies, inner walls and one enclosing wall, with enough nodes to
///                           resolve them
/// @param  points_per_width  P, number of grid points across a strip of strip_width()
/// @throws std::invalid_argument when there is not exactly one enclosing wall
/// @par Accuracy  \f$ e^{-0.09 P^2} \f$, down to 1e-13: @ref claim_07_22
/// @par Cost      area times (P / width)^2 points on the grid, 128 points per node in strips
/// @par Not for   small gaps, which the grid must resolve
FluidQuadrature fluid_quadrature(const std::vector<Curve>& curves, double points_per_width = 18.0);

}  // namespace stokesbook
