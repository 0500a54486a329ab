#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/picture.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Draws every quantity of a frame's field as SVG: a colour map in which velocities show as speed,
/// streamlines where the field has velocities, walls and bodies on top.
///
/// A point of the grid colours the square about it, in one of 65 colours; points outside the fluid
/// stay blank. The colours span the values but for the hundredth that is least and the hundredth
/// that is largest: next to bodies, and most of all between them, values may peak. Quantities that have a
/// sign are blue below and red above zero, which is grey in the middle of the bar.
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

/// Tells whether a file is one that draw_fields() names.
///
/// @param  name  of any file
/// @return       true for `fields_pressure.svg` and its like
bool is_field_picture(const std::string& name);

/// @}

}  // namespace stokesbook
