#pragma once

#include <string>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup scene
/// @{

/// Writes a scene file that needs no other file: `parse_scene(to_toml(file), ...)` equals `file`,
/// bit for bit. Points of nodal curves are written out.
///
/// @param  file  a valid scene file, as parse_scene() returns it
/// @return       the text of the file
std::string to_toml(const SceneFile& file);

/// @}

}  // namespace stokesbook
