#pragma once

#include <filesystem>

#include "scene/scene.hpp"
#include "sweep/sweep.hpp"

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// Reads a sweep file and checks everything that can be checked without its scene.
///
/// @param  path  path of the sweep file; the scene that it names is relative to its folder
/// @return       the sweep
/// @throws SceneError at the first error, with its place, the wrong value and a right one
Sweep read_sweep(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
