#pragma once

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Finds the preimage of a target, which is the complex parameter s, relative to that of node j,
/// with \f$ x(t_j + s) = z \f$ for the continued curve, to second order in the distance (06.4).
///
/// The error of the trapezoid rule at the target is about \f$ e^{-N|\mathrm{Im}\,s|} \f$.
/// @param  node  j, the nearest node for good accuracy
/// @par Accuracy  second order in the distance over the radius of curvature: @ref claim_06_35
Complex preimage(const Curve& curve, Eigen::Index node, Complex target);

/// Returns the index of the node nearest to a point, with O(N) operations.
Eigen::Index nearest_node(const Curve& curve, Complex target);

/// Returns the bound \f$ \ln(200/\varepsilon) \f$: the trapezoid rule may miss a relative tolerance
/// \f$ \varepsilon \f$ at targets with a smaller \f$ N|\mathrm{Im}\,s| \f$ (06.5).
///
/// On resolved circles, ellipses and stars the error is at most
/// \f$ 200\,e^{-N|\mathrm{Im}\,s|} \f$ down to rounding, @ref claim_06_23, and typically 10 to 20
/// times less. The tolerance > 0 is relative to the density.
double near_cut(double tolerance);

/// Estimates \f$ N|\mathrm{Im}\,s| \f$ of the nearest preimage s of a target, from the error of the
/// trapezoid rule for a Cauchy integral whose value is known.
///
/// The Cauchy integral of 1 is 1 inside the curve and 0 outside. The rule with every second node
/// has the error \f$ 1/|e^{-iNs/2} - 1| \f$ for this integral (06.2), and the square of this error
/// is about \f$ e^{-N|\mathrm{Im}\,s|} \f$. The estimate also holds for curves and gradings for
/// which preimage() is inaccurate.
/// @return        at most about 70 because of rounding; 0 to 1.4 on a node
/// @par Accuracy  the error of the rule is at most 200 times the exponential: @ref claim_06_23,
/// @ref claim_06_24
/// @par Cost      O(N)
double preimage_depth(const Curve& curve, Complex target);

/// Returns whether the trapezoid rule of a curve is too coarse at a target: whether
/// preimage_depth() is at most near_cut(). The test requires no density.
bool is_near(const Curve& curve, Complex target, double tolerance);

/// Returns a distance from the curve beyond which no target is near:
/// \f$ \max\frac{|x'|}{\gamma}(e^{\gamma|s|} - 1),\ \gamma = |x''/x'| \f$, where
/// \f$ N\,\mathrm{Im}\,s \f$ is near_cut(), and \f$ N|\mathrm{Re}\,s| \le \pi \f$ because the node
/// is the nearest one.
///
/// The continuation of a curve grows at this rate on circles, and along graded nodes about a
/// cluster.
double near_reach(const Curve& curve, double tolerance);

}  // namespace stokesbook
