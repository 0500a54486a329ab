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
/// @par Accuracy  second order in the distance over the radius of curvature: @ref claim_06_35
Complex preimage(const Curve& curve, Eigen::Index node, Complex target);

/// Finds the node nearest to a point.
///
/// @param  curve   N nodes
/// @param  target  point, length
/// @return         its index, 0 to N - 1
/// @par Cost       O(N)
Eigen::Index nearest_node(const Curve& curve, Complex target);

/// Returns \f$ N|\mathrm{Im}\,s| \f$ below which the trapezoid rule misses a relative tolerance:
/// \f$ \ln(200/\varepsilon) \f$.
///
/// On resolved circles, ellipses and stars the error is at most 200 exp(-N
/// |Im s|) down to rounding,
/// @ref claim_06_23, and typically 10 to 20 times less.
/// @param  tolerance  relative to the density, > 0
/// @return            bound of N |Im s|, dimensionless
double near_cut(double tolerance);

/// Measures how near a target is as the rule sees it: \f$ N|\mathrm{Im}\,s| \f$ of the nearest
/// preimage, from the error of a Cauchy integral of which the value is known.
///
/// With every second node the rule errs by \f$ 1/|e^{-iNs/2} - 1| \f$ for the Cauchy integral of 1;
/// the square of that error is \f$ e^{-N|\mathrm{Im}\,s|} \f$, for curves and gradings whose
/// preimages no local expansion finds.
/// @param  curve    N nodes
/// @param  target   point of the fluid, length
/// @return          dimensionless, up to about 70, where rounding ends it; 0 on a node
/// @par Accuracy    the rule errs by at most 200 times the exponential: @ref claim_06_23,
/// @ref claim_06_24
/// @par Cost        O(N)
double preimage_depth(const Curve& curve, Complex target);

/// Decides before any density is known whether the trapezoid rule of a curve is too coarse at a
/// target: where preimage_depth() is below near_cut().
///
/// @param  curve      N nodes
/// @param  target     point of the fluid, length
/// @param  tolerance  relative to the density, > 0
/// @return            true when the rule is expected to miss the tolerance
/// @par Accuracy      that of preimage_depth(), @ref claim_06_23
/// @par Cost          O(N)
bool is_near(const Curve& curve, Complex target, double tolerance);

/// Returns a distance from the curve beyond which no target is near:
/// \f$ \max\frac{|x'|}{\gamma}(e^{\gamma|s|} - 1),\ \gamma = |x''/x'| \f$, with
/// \f$ N\,\mathrm{Im}\,s = cut \f$ and \f$ N|\mathrm{Re}\,s| \le \pi \f$, as the node is the
/// nearest.
///
/// The continuation grows like that on circles, and along graded nodes about a cluster.
/// @param  curve      N nodes
/// @param  tolerance  as of is_near()
/// @return            distance, length
/// @par Cost          O(N)
double near_reach(const Curve& curve, double tolerance);

/// @}

}  // namespace stokesbook
