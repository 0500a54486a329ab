#pragma once

#include <string>

#include "record/run_data.hpp"
#include "record/svg.hpp"

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

/// Common parts of the pictures of a run. Points and lengths are in pixels.
namespace picture_parts {

/// @name Layout
/// @{
inline constexpr double margin = 14.0;         ///< around the picture
inline constexpr double header_height = 54.0;  ///< title and time, above the drawing
inline constexpr double bar_column = 84.0;     ///< colour bar and its numbers, right of the drawing
inline constexpr double bar_height = 150.0;    ///< also the least height of a drawing
inline constexpr double full_width = 648.0;    ///< width of a drawing, unless its height is limited
/// @}

/// Returns the scale, in pixels per length, at which a drawing of a region with a width and height
/// has its full width and is at most 1.4 times as high as this width.
double scale_of_drawing(Complex size);

/// Opens a picture with title and time above a drawing with a width and height; `</svg>` closes it.
std::string open_picture(Complex drawn, double t, const std::string& title);

/// Values at the ends of a colour bar.
struct ValueRange {
  double low,  ///< value of the first colour
      high;    ///< value of the last colour
};

/// Draws a colour bar with numbers, right of a drawing with a width.
/// @param  label  text above the bar
/// @param  style  other attributes of the bar
std::string draw_bar(double drawn_width, const ColourMap& map, const ValueRange& range,
                     const std::string& label, const std::string& style = {});

}  // namespace picture_parts

/// @}

}  // namespace stokesbook
