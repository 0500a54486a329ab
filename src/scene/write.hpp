#pragma once

#include <string>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup scene
/// @{

/// Writes a scene as a scene file that needs no other file: `parse_scene(to_toml(scene), ...)`
/// equals `scene`, bit for bit. Points of nodal curves are written out.
///
/// @param  scene  valid, as parse_scene() returns it
/// @return        text of a scene file
std::string to_toml(const Scene& scene);

/// @}

}  // namespace stokesbook
