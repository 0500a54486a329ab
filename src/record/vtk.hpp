#pragma once

#include <optional>
#include <span>
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

/// Names the file with the configuration of a frame.
///
/// @param  frame  its number, from 0
/// @return        `bodies_000042.vtp`; more digits where six do not do
std::string vtp_name(std::size_t frame);

/// Reads the number of the frame from the name of its file.
///
/// @param  name  of any file
/// @return       number, or nothing for other names
std::optional<std::size_t> frame_of_vtp(const std::string& name);

/// Ties the files of all frames to their times, as a ParaView collection.
///
/// @param  frame_times  one a frame, from the first
/// @return              text of `bodies.pvd`
std::string collection_pvd(std::span<const double> frame_times);

/// @}

}  // namespace stokesbook
