#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/error.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup scene
/// @{

/// Reads a scene file and the files it names, checks all that can be checked without solving, and
/// fills in the defaults.
///
/// @param  path       of the scene file; the files it names are relative to its folder
/// @param  overrides  values of the command line, in order, that replace or add to the file's:
///                    `time.dt=0.01`, `bodies.0.n_nodes=64`; path, `=`, value in TOML's syntax
/// @return            scene and fills, checked
/// @throws SceneError at the first thing that is wrong, with place, value and what would be right
SceneFile read_scene(const std::filesystem::path& path,
                     std::span<const std::string> overrides = {});

/// Reads a scene from its text.
///
/// @param  text       TOML
/// @param  file_name  what messages call the text
/// @param  directory  what the files it names are relative to
/// @param  overrides  as read_scene() takes them
/// @return            scene and fills, checked
/// @throws SceneError as read_scene() does
SceneFile parse_scene(std::string_view text, std::string_view file_name,
                      const std::filesystem::path& directory,
                      std::span<const std::string> overrides = {});

/// @}

}  // namespace stokesbook
