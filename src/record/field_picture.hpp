#pragma once

#include <map>
#include <string>

#include "record/run_data.hpp"

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
/// @param  title  shown above each picture
/// @return        SVG documents by file name, such as `fields_pressure.svg`
/// @throws std::invalid_argument when the numbers of outlines and states differ, or there is no
///                               field
std::map<std::string, std::string> draw_fields(const Frame& frame, const Outlines& outlines,
                                               const std::string& title);

/// Returns whether a file name is one of those that draw_fields() returns.
bool is_field_picture(const std::string& name);

/// @}

}  // namespace stokesbook
