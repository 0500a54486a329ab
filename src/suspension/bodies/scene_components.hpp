#pragma once

#include <cstddef>
#include <string>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Names a component for messages and contact tables.
///
/// @param  scene      that it is part of
/// @param  component  bodies first, then walls
/// @return            "body 3" or "wall 0", both counted from 0
std::string component_name(const Scene& scene, std::size_t component);

/// Returns the number of nodes that the scene gives a component.
///
/// @param  scene      that it is part of
/// @param  component  bodies first, then walls
/// @return            nodes, or automatic_nodes
int given_nodes(const Scene& scene, std::size_t component);

/// @}

}  // namespace stokesbook
