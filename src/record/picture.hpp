#pragma once

#include <string>

#include "record/run_data.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Draws a configuration as an SVG document, for display alone or inside a page, on a light or dark
/// background.
///
/// Bodies are coloured by their speed |U| (viridis, with a colour bar). A tick on each body marks
/// the first axis of its frame, and an arrow shows its velocity. Contact forces are lines from the
/// bodies to the points where the forces act; the width grows with the force. Walls are outlines; y
/// points upwards.
/// @param  title  shown above the picture, read by screen readers; may be empty
/// @throws std::invalid_argument when the numbers of outlines and states differ, or there is
///                               nothing to draw
std::string draw_configuration(const Frame& frame, const Outlines& outlines,
                               const std::string& title);

/// @}

}  // namespace stokesbook
