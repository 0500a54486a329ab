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

/// Reads a scene file and the files that it names, checks everything that can be checked without a
/// solve, and fills in the defaults.
///
/// @param  path       path of the scene file; files that it names are relative to its folder
/// @param  overrides  values from the command line, in order, which replace values of the file or
///                    add to them: `time.dt=0.01`, `bodies.0.n_nodes=64`; path, `=`, value in
///                    TOML's syntax
/// @return            scene and fills, checked
/// @throws SceneError at the first error, with its place, the wrong value and a right one
SceneFile read_scene(const std::filesystem::path& path,
                     std::span<const std::string> overrides = {});

/// Reads a scene from its text.
///
/// @param  text       TOML
/// @param  file_name  name of the text in messages
/// @param  directory  folder that files named in the text are relative to
/// @param  overrides  as for read_scene()
/// @return            scene and fills, checked
/// @throws SceneError as read_scene() does
SceneFile parse_scene(std::string_view text, std::string_view file_name,
                      const std::filesystem::path& directory,
                      std::span<const std::string> overrides = {});

/// @}

}  // namespace stokesbook
