#pragma once

#include <string>
#include <vector>

#include "record/outline.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Options of a picture.
struct PictureOptions {
  std::string title;     ///< shown above the picture, read by screen readers; may be empty
  double width = 760.0;  ///< width of the whole picture, pixels
};

/// Draws a configuration as SVG, for display alone or inside a page, on a light or dark background.
///
/// Bodies are coloured by their speed |U| (viridis, with a colour bar). A tick on each body marks
/// the first axis of its frame, and an arrow shows its velocity. Contact forces are lines from the
/// bodies to the points where the forces act; the width grows with the force. Walls are outlines; y
/// points upwards.
/// @param  frame    the configuration and its velocities
/// @param  bodies   outlines in the order of frame.bodies
/// @param  walls    outlines in the order of frame.walls
/// @param  options  title and size
/// @return          an SVG document
/// @throws std::invalid_argument when the numbers of outlines and states differ, or there is
///                               nothing to draw
std::string draw_configuration(const Frame& frame, const std::vector<Outline>& bodies,
                               const std::vector<Outline>& walls, const PictureOptions& options);

/// @}

}  // namespace stokesbook
