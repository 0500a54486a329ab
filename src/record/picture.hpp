#pragma once

#include <string>
#include <vector>

#include "record/outline.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// How a picture looks.
struct PictureOptions {
  std::string title;     ///< above the picture and for screen readers; may be empty
  double width = 760.0;  ///< of the whole picture, pixels
};

/// Draws a configuration as SVG, to be shown on its own or inside a page, on light or dark ground.
///
/// Bodies are filled by speed |U| (viridis, with a colour bar); a tick on each marks its direction
/// 1, arrows its velocity. Forces of contact are lines to where they act, the wider the larger.
/// Walls are outlines; y points upwards.
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
