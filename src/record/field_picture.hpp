#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/picture.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Draws every quantity of a frame's field as SVG: a colour map (of the speed, for velocities),
/// streamlines if the field has velocities, and walls and bodies on top.
///
/// Each point of the grid colours the square around it with one of 65 colours. Points outside the
/// fluid have no colour, except next to the fluid, where they take the mean of their neighbours.
/// The colours do not resolve the smallest and the largest hundredth of the values, since values
/// may peak next to bodies and between them. For quantities with a sign the range of the colours is
/// symmetric: blue below zero, red above, and grey at zero.
/// @param  frame    the configuration with its field
/// @param  bodies   outlines in the order of frame.bodies
/// @param  walls    outlines in the order of frame.walls
/// @param  options  title and size
/// @return          SVG documents by file name, `fields_pressure.svg`
/// @throws std::invalid_argument when the numbers of outlines and states differ, or there is no
///                               field
std::map<std::string, std::string> draw_fields(const Frame& frame,
                                               const std::vector<Outline>& bodies,
                                               const std::vector<Outline>& walls,
                                               const PictureOptions& options);

/// Returns whether a file name is one of those that draw_fields() returns.
///
/// @param  name  name of any file
/// @return       true for `fields_velocity.svg`, `fields_pressure.svg`, and so on
bool is_field_picture(const std::string& name);

/// @}

}  // namespace stokesbook
