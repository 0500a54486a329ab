#pragma once

#include <memory>
#include <vector>

#include "trapezoid/curve.hpp"
#include "trapezoid/grading.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// A curve placed in the plane that can be evaluated between its nodes.
struct SmoothCurve {
  Curve nodes;                                   ///< nodes in the plane
  std::shared_ptr<const Parametrisation> shape;  ///< curve in its own frame
  Complex position;                              ///< origin of this frame in the plane, length
  double orientation = 0.0;                      ///< radians, counter-clockwise
  std::vector<GradedParameter> parameters = {};  ///< parameters of nodes that are not equidistant

  double parameter(Eigen::Index node) const;        ///< returns the parameter of a node, radians
  TrigonometricPolynomial::Jet at(double t) const;  ///< evaluates x, x' and x'' in the plane
};

/// Moves a curve by a vector, length.
SmoothCurve translated(SmoothCurve curve, Complex vector);

/// Foot of the perpendicular from a point to a curve.
struct Foot {
  double parameter;                 ///< t, radians
  TrigonometricPolynomial::Jet at;  ///< the curve there, length
};

/// Finds the foot of the perpendicular from a point z, \f$ (x(t)-z)\cdot x'(t) = 0 \f$, by Newton's
/// method for the minimum of \f$ |x(t)-z|^2 \f$. Where this function of t is not convex, each step
/// goes in the direction in which the function decreases.
///
/// @param  guess    parameter near that of the foot, radians
/// @param  longest  longest step allowed, radians, for example the distance between nodes
/// @par Accuracy    rounding of the positions, if the point is nearer to the curve than the centre
/// of curvature, @ref claim_06_36
/// @par Cost        a few evaluations of the curve, 31 at most
Foot find_foot(const Parametrisation& curve, Complex point, double guess, double longest);

/// The closest points of two curves, and the gap between them.
struct ClosestPoints {
  double gap = 0.0;  ///< distance through the fluid; about minus the depth if the curves overlap
  double parameter_a = 0.0,  ///< parameter of point_a on curve a, radians
      parameter_b = 0.0;     ///< parameter of point_b on curve b, radians
  Complex point_a,           ///< on curve a, length
      point_b;               ///< on curve b, length
};

/// Measures the smallest distance between two curves through the fluid between them.
///
/// Newton's method minimises the height of curve a over curve b, which is the signed distance of a
/// point of a from its foot on b. Unlike the distance, the height is regular also where the curves
/// touch or overlap. The height is sampled at four points per node of a, and a descent starts
/// wherever it turns from falling to rising. Therefore all minima are found, also if their heights
/// hardly differ, and curves that touch or overlap are distinguished from curves that are only
/// near, wherever the nodes are.
/// @par Accuracy  rounding of the positions, gaps of 1e-8 included: @ref claim_06_36
/// @par Cost      N_a N_b distances between nodes, and some twenty evaluations of the curves for
/// each node that may be next to the closest point
ClosestPoints closest_points(const SmoothCurve& a, const SmoothCurve& b);

/// Descends from the parameter s of curve a, and the parameter t of curve b near the foot of this
/// point, to a local minimum of the distance between the curves, as accurately as closest_points().
///
/// @par Cost  about five evaluations of the curves per Newton step
ClosestPoints closest_points_near(const SmoothCurve& a, const SmoothCurve& b, double s, double t);

}  // namespace stokesbook
