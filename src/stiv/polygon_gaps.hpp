#pragma once

#include <vector>

#include "stiv/near_pairs.hpp"

namespace stokesbook {

/// The gap of two polygons.
struct PolygonGap {
  std::size_t a;   ///< one component
  std::size_t b;   ///< the other component, a < b
  double gap;      ///< least signed distance of a vertex of one polygon from the other, length; if
                   ///< they overlap, minus the depth of the deepest vertex, at most 0
  Complex point;   ///< place of this vertex in the plane, length
  Complex normal;  ///< derivative of the gap by the displacement of a, unit
};

/// Measures the gaps of all pairs of polygons that are nearer to each other than `reach` > 0, at
/// rest, ascending by pair. The result decides whether a state is accepted, independently of the
/// search along the paths.
///
/// The signed distance is computed for every vertex in reach. Edges that cross are an overlap, even
/// if no vertex lies inside the other polygon. A body inside a body, or outside the enclosing wall,
/// is an overlap.
/// @throws std::invalid_argument when numbers of shapes and poses differ, or a pose is not finite
/// @par Accuracy   rounding for the polygons, @ref claim_10_19
/// @par Cost       O(n log n), and for each pair a query for each vertex in reach, and for each
///                 edge of one polygon
std::vector<PolygonGap> polygon_gaps(const ContactShapes& shapes, const std::vector<Pose>& poses,
                                     double reach);

}  // namespace stokesbook
