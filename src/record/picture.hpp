#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/run_data.hpp"

namespace stokesbook {

/// The path of a body.
struct BodyPath {
  std::size_t body;      ///< index of the body in the frame
  ComplexVector points;  ///< positions in order of time, at least one, length
};

/// Draws a configuration as an SVG document, for display alone or inside a page, on a light or dark
/// background.
///
/// Bodies are coloured by their speed |U| (viridis, with a colour bar). A tick on each body marks
/// the first axis of its frame, and an arrow shows its velocity. Contact forces are lines from the
/// bodies to the points where the forces act; the width grows with the force. Walls are outlines; y
/// points upwards. Tracers are dots. The edge of a periodic cell is an outline, and images of
/// bodies at this edge are grey; see in_cell(). Each path has a colour of its own, and the number
/// of its body at its beginning.
/// @param  title  shown above the picture; may be empty
/// @throws std::invalid_argument when outlines and frame do not match, or have no component
std::string draw_configuration(const Frame& frame, const Outlines& outlines,
                               const std::string& title, const std::vector<BodyPath>& paths = {});

/// Draws every quantity of a frame's field as SVG: a colour map (of the speed, for velocities),
/// streamlines if the field has velocities, and walls, bodies and tracers on top.
///
/// Each point of the grid colours the square around it with one of 65 colours. Points outside the
/// fluid have no colour, except next to the fluid, where they take the mean of their neighbours.
/// The colours do not resolve the smallest and the largest hundredth of the values, since values
/// may peak next to bodies and between them. For quantities with a sign the range of the colours is
/// symmetric: blue below zero, red above, and grey at zero.
/// @return  SVG documents by file name, such as `fields_pressure.svg`
/// @throws std::invalid_argument when outlines and frame do not match, or there is no field
std::map<std::string, std::string> draw_fields(const Frame& frame, const Outlines& outlines,
                                               const std::string& title);

/// Returns whether a file name is one of those that draw_fields() returns.
bool is_field_picture(const std::string& name);

}  // namespace stokesbook
