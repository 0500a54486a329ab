#pragma once

#include <string>
#include <vector>

#include "record/outline.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Draws a configuration as VTK PolyData (XML, ASCII): one cell a wall and body.
///
/// Enclosing walls are closed polylines and come first, as VTK orders cells; then one polygon a
/// body and inner wall, concave or not. Cell data: `id` (index of the body, or -1 - index of the
/// wall), `velocity` and `omega` (0 for walls), `theta`, `force` and `torque` (by the body or wall
/// on the fluid).
/// @param  frame   the configuration and its velocities
/// @param  bodies  outlines in the order of frame.bodies
/// @param  walls   outlines in the order of frame.walls
/// @return         text of a `.vtp` file
/// @throws std::invalid_argument when the numbers of outlines and states differ
std::string configuration_vtp(const Frame& frame, const std::vector<Outline>& bodies,
                              const std::vector<Outline>& walls);

/// @}

}  // namespace stokesbook
