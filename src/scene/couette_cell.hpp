#pragma once

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup scene
/// @{

/// Finds the only wall with a given role.
///
/// @param  scene  any scene
/// @param  role   outer or inner
/// @return        the wall in the scene; null if there is none, or more than one
const Wall* only_wall(const Scene& scene, WallRole role);

/// Returns whether a scene is a Couette cell: one outer and one inner wall, each fixed or rotating,
/// at different rates.
///
/// @param  scene  any scene
/// @return        true if the torque on the inner wall measures an effective viscosity
bool is_couette_cell(const Scene& scene);

/// @}

}  // namespace stokesbook
