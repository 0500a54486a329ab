#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/run.hpp"

namespace stokesbook {

/// Chooses the bodies whose paths are drawn if the user names none: all bodies, or ten of them at
/// equal distances in the list if there are more than twenty.
std::vector<std::size_t> bodies_to_draw(const Scene& scene);

/// Plots a run as SVG: the last configuration with the paths of bodies and the walls as they are at
/// t = 0, each quantity of the rheology that the scene defines, the least gap, and the cost.
/// @param  bodies  bodies whose paths are drawn
/// @return         SVG documents by file name, such as `paths.svg`
/// @throws SceneError when there is no body with one of the numbers
std::map<std::string, std::string> draw_run(const Run& run, const std::vector<std::size_t>& bodies);

}  // namespace stokesbook
