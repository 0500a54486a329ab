#pragma once

#include <memory>
#include <vector>

#include "stiv/polygon.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// The shape of a component for contact, in its own frame: a polygon whose vertices lie on the
/// curve.
struct ContactShape {
  Polygon polygon;          ///< M vertices on the curve
  Eigen::VectorXd weights;  ///< half the lengths of the two edges at each vertex, length
  double sag;               ///< bound of the distance between curve and polygon, length
  double radius;            ///< largest distance of a vertex from the frame's origin, length
};

/// The shapes of all components. Components of the same shape share one ContactShape.
using ContactShapes = std::vector<std::shared_ptr<const ContactShape>>;

/// Bounds the distance of a curve from its chords between neighbouring nodes (10.1):
/// \f$ \max \kappa h^2/8 = \max |x' \times x''|\,(2\pi/N)^2/(8|x'|) \f$.
///
/// @par Accuracy  relative to second order in the spacing of the nodes; polygons touch earlier or
///                later than their curves, by the sum of two sags, @ref claim_10_2, @ref claim_10_3
double sag(const Curve& curve);

/// Makes the polygon whose vertices are the nodes of a curve, in its own frame and resolved by its
/// nodes.
ContactShape contact_shape(const Curve& curve);

/// Makes the polygon of a shape with so many vertices that its sag does not exceed a limit. The
/// number of vertices grows as \f$ 1/\sqrt{sag} \f$.
///
/// @param  sag_limit  largest sag that is allowed, length, > 0; a twentieth of the separation is
///                    small enough for the gaps of polygons to replace the gaps of curves
/// @return            vertices equidistant in the shape's parameter
/// @par Cost          O(M), for a NodalCurve O(M log M)
ContactShape contact_shape(const Shape& shape, Side side, double sag_limit);

}  // namespace stokesbook
