#pragma once

#include <filesystem>

#include "scene/error.hpp"
#include "sweep/sweep.hpp"

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// Reads a sweep file and checks all that can be checked without its scene.
///
/// @param  path  of the sweep file; the scene it names is relative to its folder
/// @return       the sweep
/// @throws SceneError at the first thing that is wrong, with place, value and what would be right
Sweep read_sweep(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
