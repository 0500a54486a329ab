#pragma once

#include <memory>
#include <vector>

#include "stiv/polygon.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// A curve as contact sees it, in its own frame: the polygon of points on it.
struct ContactShape {
  Polygon polygon;          ///< M vertices on the curve
  Eigen::VectorXd weights;  ///< half the lengths of the two edges at each vertex, length
  double sag;               ///< bound of how far the curve lies from the polygon, length
  double radius;            ///< largest distance of a vertex from the frame's origin, length
};

/// The shapes of all components; components of one shape share it.
using ContactShapes = std::vector<std::shared_ptr<const ContactShape>>;

/// Bounds how far a curve lies from its chords between neighbouring nodes:
/// \f$ \max \kappa h^2/8 = \max |x' \times x''|\,(2\pi/N)^2/(8|x'|) \f$.
///
/// Gaps of curves are narrower than those of their polygons by at most the sum of the two sags.
/// @param  curve  N nodes
/// @return        sag, length
/// @par Accuracy  relative to second order in the spacing of the nodes: contact between polygons is
/// early or late by the sum of two sags, @ref claim_10_2 and @ref claim_10_3
double sag(const Curve& curve);

/// Takes the nodes of a curve for the vertices of its polygon.
///
/// @param  curve  in its own frame, resolved by its nodes
/// @return        polygon with as many vertices
ContactShape contact_shape(const Curve& curve);

/// Samples a shape so finely that the curve is as near to the polygon as asked for: vertices in
/// numbers that grow as \f$ 1/\sqrt{sag} \f$.
///
/// @param  shape     in its own frame
/// @param  side      where the fluid lies
/// @param  sag_limit largest sag that is allowed, length, > 0; a twentieth of the separation is
///                   small enough that the polygons' gaps stand for the curves'
/// @return           polygon with vertices equidistant in the shape's parameter
/// @throws std::invalid_argument when sag_limit is not positive
/// @par Cost         O(M), for a NodalCurve O(M log M)
ContactShape contact_shape(const Shape& shape, Side side, double sag_limit);

/// @}

}  // namespace stokesbook
