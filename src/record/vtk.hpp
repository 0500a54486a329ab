#pragma once

#include <string>
#include <vector>

#include "record/outline.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Writes a configuration as VTK PolyData (XML, ASCII), with one cell for each wall and body.
///
/// Enclosing walls are closed polylines and come first, since VTK orders lines before polygons.
/// Each body and inner wall is a polygon, which may be concave. Cell data: `id` (index of the body,
/// or -1 - index of the wall), `velocity` and `omega` (0 for walls), `theta`, `force` and `torque`
/// (by the body or wall on the fluid).
/// @param  frame   the configuration and its velocities
/// @param  bodies  outlines in the order of frame.bodies
/// @param  walls   outlines in the order of frame.walls
/// @return         text of a `.vtp` file
/// @throws std::invalid_argument when the numbers of outlines and states differ
std::string configuration_vtp(const Frame& frame, const std::vector<Outline>& bodies,
                              const std::vector<Outline>& walls);

/// Writes the network of contacts as VTK PolyData (XML, ASCII), with one polyline for each contact.
///
/// A line goes from the centre of a through the contact point to the centre of b; the end at a wall
/// is the contact point itself. Cell data: `a` and `b` (the `id` of configuration_vtp()), `normal`,
/// `force` and `gap` as in ContactForce.
/// @param  frame  the configuration with its contacts, whose bodies must be in the frame
/// @return        text of a `.vtp` file
std::string contacts_vtp(const Frame& frame);

/// @}

}  // namespace stokesbook
