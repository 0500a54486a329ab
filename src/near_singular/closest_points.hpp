#pragma once

#include <memory>
#include <vector>

#include "trapezoid/curve.hpp"
#include "trapezoid/grading.hpp"
#include "trapezoid/parametrisation.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// A curve placed in the plane that can be evaluated between its nodes.
struct SmoothCurve {
  Curve nodes;                                   ///< placed
  std::shared_ptr<const Parametrisation> shape;  ///< in the curve's own frame
  Complex position;                              ///< of the frame's origin, length
  double orientation = 0.0;                      ///< radians, counter-clockwise
  std::vector<GradedParameter> parameters = {};  ///< of the nodes; none where they are equidistant

  /// Returns the parameter of a node.
  ///
  /// @param  node  its number
  /// @return       parameter, radians
  double parameter(Eigen::Index node) const;

  /// Evaluates point and derivatives at a parameter, in the plane.
  ///
  /// @param  t  parameter, radians
  /// @return    x, x' and x'' at t, length
  /// @par Cost  that of the parametrisation
  TrigonometricPolynomial::Jet at(double t) const;
};

/// Where the perpendicular from a point stands on a curve.
struct Foot {
  double parameter;                 ///< t, radians
  TrigonometricPolynomial::Jet at;  ///< the curve there, length
};

/// Finds the foot of the perpendicular from a point z, \f$ (x(t)-z)\cdot x'(t) = 0 \f$, by Newton's
/// method for the least distance; where the distance is not convex, its steps go downhill.
///
/// @param  curve    as a function of its parameter, length
/// @param  point    z, length
/// @param  guess    parameter near the foot's, radians
/// @param  longest  step that is allowed, radians, such as that between nodes
/// @return          the foot
/// @par Accuracy    rounding of the positions, where the point is nearer than the curve's centre of
/// curvature, @ref claim_06_36
/// @par Cost        a few evaluations of the curve, 31 at most
Foot find_foot(const Parametrisation& curve, Complex point, double guess, double longest);

/// Where two curves come closest.
struct ClosestPoints {
  double gap = 0.0;  ///< distance through the fluid; when the curves overlap, minus about the depth
  double parameter_a = 0.0,  ///< of point_a on its curve, radians
      parameter_b = 0.0;     ///< of point_b on its curve, radians
  Complex point_a,           ///< on the one curve, length
      point_b;               ///< on the other curve, length
};

/// Measures the least distance of two curves through the fluid between them.
///
/// Newton's method minimises the height of one curve over the other, which is regular at contact
/// and beyond it, from wherever that height turns from falling to rising along the curve, looked at
/// four times a node. So minima that hardly differ are all found, and curves that touch or overlap
/// are told from near ones wherever their nodes are.
/// @param  a  one curve, N_a nodes
/// @param  b  the other, N_b nodes
/// @return    gap and where it is
/// @par Accuracy  rounding of the positions, gaps of 1e-8 included: @ref claim_06_36
/// @par Cost      N_a N_b distances, and some twenty evaluations of the curves for each node that
/// may be next to the closest point
ClosestPoints closest_points(const SmoothCurve& a, const SmoothCurve& b);

/// Descends from a pair of points to the next local minimum of the distance of two curves.
///
/// @param  a  one curve, N_a nodes
/// @param  b  the other, N_b nodes
/// @param  s  parameter on the one, radians
/// @param  t  parameter on the other near the foot of that point, radians
/// @return    gap and where it is
/// @par Accuracy  as closest_points(), @ref claim_06_36
/// @par Cost      about five evaluations of the curves a Newton step
ClosestPoints closest_points_near(const SmoothCurve& a, const SmoothCurve& b, double s, double t);

/// @}

}  // namespace stokesbook
