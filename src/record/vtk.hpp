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

/// Draws the network of contacts as VTK PolyData (XML, ASCII): one polyline a contact.
///
/// A line goes from the centre of a by the contact point to the centre of b; at a wall it ends in
/// the point. Cell data: `a` and `b` (the `id` of configuration_vtp()), `normal`, `force` and
/// `gap` as in ContactForce.
/// @param  frame  with its contacts, of bodies that it has
/// @return        text of a `.vtp` file
std::string contacts_vtp(const Frame& frame);

/// @}

}  // namespace stokesbook
