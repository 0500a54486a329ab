#pragma once

#include <vector>

#include "stiv/contact_shape.hpp"
#include "stiv/rigid_path.hpp"
#include "stiv/separation.hpp"

namespace stokesbook {

/// Returns the least rectangle that holds the polygon of a component, with O(M) operations.
Rectangle bounding_rectangle(const ContactShape& shape, const Pose& pose);

/// Returns a rectangle that holds the polygon of a component at all times of a step, with O(M)
/// operations.
///
/// The rectangle holds the bounding rectangles at start and end, and is widened by the distance by
/// which a turning point may leave both in between, at most \f$ |X|\Delta\theta^2/8 \f$.
Rectangle swept_rectangle(const ContactShape& shape, const RigidPath& path);

/// Finds the pairs of components whose rectangles are near each other: the broad phase. An
/// enclosing wall is near every component that it encloses.
///
/// @param  reach       distance in each coordinate up to which rectangles are near, length
/// @return             pairs, ascending
/// @par Cost           O(n log n + p) for p pairs, as long as rectangles overlap few others
std::vector<ComponentPair> near_pairs(const ContactShapes& shapes,
                                      const std::vector<Rectangle>& rectangles, double reach);

}  // namespace stokesbook
