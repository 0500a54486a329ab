#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup stress
/// @{

/// Points and weights of a quadrature rule over an area.
struct FluidQuadrature {
  ComplexVector points;     ///< m points, length
  Eigen::VectorXd weights;  ///< m weights, > 0, length^2
};

/// Resolution of fluid_quadrature().
struct FluidQuadratureSettings {
  double width = 0.0;            ///< of the strips, length; 0: strip_width() chooses
  double points_a_width = 18.0;  ///< grid points across a strip
};

/// Chooses the width of the strips of fluid_quadrature(): half the least gap, and at most half the
/// least radius of curvature where a curve is hollow towards the fluid.
///
/// @param  curves  of the boundary, at least one
/// @return         width, length
/// @par Cost       that of closest_points() a pair
double strip_width(const std::vector<Curve>& curves);

/// Makes a quadrature rule for smooth functions on the fluid between bodies and an enclosing wall.
///
/// In a strip of width \f$ \delta \f$ along each curve the points are \f$ x(t) - d\,n(t) \f$, by
/// the trapezoid rule in t and Gauss's rule in d, weighted with a cut-off \f$ \chi(d/\delta) =
/// \frac12\mathrm{erfc}(\beta(2d/\delta-1)) \f$ from 1 on the curve to 0. What is left,
/// \f$ (1-\sum\chi)f \f$ extended by zero, is smooth in the plane up to rounding: sums over a
/// square grid converge faster than any power of its spacing.
/// @param  curves    bodies, inner walls and one enclosing wall; their nodes resolve them
/// @param  settings  width of the strips and spacing of the grid
/// @return           points in the fluid with their weights
/// @throws std::invalid_argument when there is not exactly one enclosing wall
/// @par Accuracy     e^{-.09 P^2} with P grid points across a strip, down to
/// 1e-13: @ref claim_07_22
/// @par Cost         area times (18 / width)^2 points of the grid, 128 times the nodes in strips
/// @par Not for      small gaps, which the grid must resolve
FluidQuadrature fluid_quadrature(const std::vector<Curve>& curves,
                                 const FluidQuadratureSettings& settings = {});

/// @}

}  // namespace stokesbook
