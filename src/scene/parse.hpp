#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace stokesbook {

/// Reads a scene file and the files that it names, checks everything that can be checked without a
/// solve, and fills in the defaults. Names of files are relative to the folder of the scene file.
/// @param  overrides  values from the command line, in order, which replace values of the file or
///                    add to them, such as `time.dt=0.01`; see scene_text::with_override()
/// @throws SceneError at the first error, with its place, the wrong value and a right one
SceneFile read_scene(const std::filesystem::path& path,
                     std::span<const std::string> overrides = {});

/// Reads a scene from its text, as read_scene() does from a file of this name in this directory.
SceneFile parse_scene(std::string_view text, std::string_view file_name,
                      const std::filesystem::path& directory,
                      std::span<const std::string> overrides = {});

}  // namespace stokesbook
