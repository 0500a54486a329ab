#pragma once

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// Finds the complex parameter s relative to node j that the curve's continuation maps to a target,
/// \f$ x(t_j + s) = z \f$, to second order in the distance.
///
/// The trapezoid rule at the target errs by about \f$ e^{-N|\mathrm{Im}\,s|} \f$.
/// @param  curve   nodes
/// @param  node    j, the nearest node for good accuracy
/// @param  target  z, length
/// @return         s, dimensionless
Complex preimage(const Curve& curve, Eigen::Index node, Complex target);

/// Returns the index of the node nearest to a point.
Eigen::Index nearest_node(const Curve& curve, Complex target);

/// Returns \f$ N|\mathrm{Im}\,s| \f$ below which the trapezoid rule misses a relative tolerance:
/// \f$ \ln(200/\varepsilon) \f$.
///
/// Measured on resolved circles, ellipses and stars: error <= 200 exp(-N |Im s|) down to rounding,
/// typically 10 to 20 times less.
double near_cut(double tolerance);

/// Decides before any density is known whether the trapezoid rule of a curve is too coarse at a
/// target.
///
/// @param  curve      nodes
/// @param  target     point of the fluid, length
/// @param  tolerance  relative to the density, > 0
bool is_near(const Curve& curve, Complex target, double tolerance);

/// Returns a distance from the curve beyond which no target is near, length:
/// \f$ \max(|x'||s| + \frac12|x''||s|^2) \f$ with \f$ N\,\mathrm{Im}\,s = cut \f$ and
/// \f$ N|\mathrm{Re}\,s| \le \pi \f$, as the node is the nearest.
double near_reach(const Curve& curve, double tolerance);

/// @}

}  // namespace stokesbook
