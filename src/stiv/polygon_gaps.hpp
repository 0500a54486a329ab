#pragma once

#include <vector>

#include "stiv/near_pairs.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// How near two polygons are.
struct PolygonGap {
  std::size_t a;  ///< one component
  std::size_t b;  ///< the other one, a < b
  double gap;     ///< least signed distance of a vertex of either from the other, length; at most 0
                  ///< where polygons overlap, minus the depth of the deepest vertex
  Complex point;  ///< that vertex, in the plane, length
};

/// Measures all pairs of polygons that are near each other, at rest: the test that accepts a state,
/// whatever found it.
///
/// Every vertex in reach is asked for its signed distance, and edges that cross count as overlap
/// also where no vertex lies inside. A body in a body, or outside the
/// enclosing wall, is an overlap.
/// @param  shapes  of n components
/// @param  poses   of the same
/// @param  reach   gaps that are as wide as that are left out, length, > 0
/// @return         pairs with narrower gaps, ascending by pair
/// @throws std::invalid_argument when numbers of shapes and poses differ, or a pose is not finite
/// @par Accuracy   rounding for the polygons, @ref claim_10_19
/// @par Cost       O(n log n), and for each pair a query for each vertex in reach, and for each
/// edge of one polygon
std::vector<PolygonGap> polygon_gaps(const ContactShapes& shapes, const std::vector<Pose>& poses,
                                     double reach);

/// @}

}  // namespace stokesbook
