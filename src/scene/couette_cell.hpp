#pragma once

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup scene
/// @{

/// Finds the wall of a role, if there is exactly one.
///
/// @param  scene  any
/// @param  role   outer or inner
/// @return        the wall in the scene; null where there is none, or more than one
const Wall* only_wall(const Scene& scene, WallRole role);

/// Tells whether a scene is a Couette cell: one outer and one inner wall, each fixed or rotating,
/// at different rates.
///
/// @param  scene  any
/// @return        whether its inner wall measures viscosity
bool is_couette_cell(const Scene& scene);

/// @}

}  // namespace stokesbook
