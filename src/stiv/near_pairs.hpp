#pragma once

#include <vector>

#include "stiv/component_pair.hpp"
#include "stiv/contact_shape.hpp"
#include "stiv/rigid_path.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// Returns the bounding rectangle of a component.
///
/// @param  shape  of the component
/// @param  pose   of its frame
/// @return        the least rectangle that holds its polygon
/// @par Cost      O(M)
Rectangle bounding_rectangle(const ContactShape& shape, const Pose& pose);

/// Bounds the places that a component reaches in one step, by a rectangle.
///
/// The rectangle holds the bounding rectangles at start and end, and is widened by the distance by
/// which a turning point may leave both in between, at most \f$ |X|\Delta\theta^2/8 \f$.
/// @param  shape  of the component
/// @param  path   of its frame
/// @return        a rectangle that holds its polygon at all times of the step
/// @par Cost      O(M)
Rectangle swept_rectangle(const ContactShape& shape, const RigidPath& path);

/// Finds the pairs of components whose rectangles are near each other: the broad phase. An
/// enclosing wall is near every component that it encloses.
///
/// @param  shapes      of n components
/// @param  rectangles  of the same components
/// @param  reach       distance in each coordinate up to which rectangles are near, length
/// @return             pairs, ascending
/// @par Cost           O(n log n + p) for p pairs, as long as rectangles overlap few others
std::vector<ComponentPair> near_pairs(const ContactShapes& shapes,
                                      const std::vector<Rectangle>& rectangles, double reach);

/// @}

}  // namespace stokesbook
