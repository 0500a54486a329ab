#pragma once

#include <vector>

#include "stiv/component_pair.hpp"
#include "stiv/contact_shape.hpp"
#include "stiv/rigid_path.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// Bounds where a component is.
///
/// @param  shape  of the component
/// @param  pose   where its frame is
/// @return        the least rectangle that holds its polygon
/// @par Cost      O(M)
Rectangle bounding_rectangle(const ContactShape& shape, const Pose& pose);

/// Bounds where a component comes in one step: the rectangles at start and end, and what turning
/// adds between them, \f$ |X|\Delta\theta^2/8 \f$ at most.
///
/// @param  shape  of the component
/// @param  path   of its frame
/// @return        a rectangle that holds its polygon at all times of the step
/// @par Cost      O(M)
Rectangle swept_rectangle(const ContactShape& shape, const RigidPath& path);

/// Finds the pairs of components whose rectangles come near each other: the broad phase. An
/// enclosing wall is near everything.
///
/// @param  shapes      of n components
/// @param  rectangles  of the same
/// @param  reach       distance of rectangles, by coordinate, up to which they are near, length
/// @return             pairs, ascending
/// @par Cost           O(n log n + p) for p pairs, as long as rectangles overlap few others
std::vector<ComponentPair> near_pairs(const ContactShapes& shapes,
                                      const std::vector<Rectangle>& rectangles, double reach);

/// @}

}  // namespace stokesbook
