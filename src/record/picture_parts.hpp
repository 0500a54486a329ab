#pragma once

#include <string>

#include "record/colour_map.hpp"
#include "record/picture.hpp"

/// Common parts of the pictures of a run. Points and lengths are in pixels.
namespace stokesbook::picture_parts {

/// @addtogroup record
/// @{

/// @name Layout
/// @{
inline constexpr double margin = 14.0;         ///< around the picture
inline constexpr double header_height = 54.0;  ///< title and time, above the drawing
inline constexpr double bar_column = 84.0;     ///< colour bar and its numbers, right of the drawing
inline constexpr double bar_height = 150.0;    ///< also the least height of a drawing
/// @}

/// Returns the scale at which a drawing fills its column and is at most 1.4 times as high as the
/// column is wide.
///
/// @param  size   width and height of the drawn region, length
/// @param  width  width of the whole picture
/// @return        pixels per length
double scale_of_drawing(Complex size, double width);

/// Opens a picture and writes title and time above the drawing.
///
/// @param  drawn    width and height of the drawing
/// @param  t        time
/// @param  options  title, and the width up to which a long title widens the picture
/// @return          the picture without its drawing; `</svg>` closes it
std::string open_picture(Complex drawn, double t, const PictureOptions& options);

/// Values at the ends of a colour bar.
struct ValueRange {
  double low,  ///< value of the first colour
      high;    ///< value of the last colour
};

/// Draws a colour bar with numbers, right of the drawing.
///
/// @param  drawn_width  width of the drawing
/// @param  map          the colour map
/// @param  range        values at both ends
/// @param  label        text above the bar
/// @param  style        other attributes of the bar
/// @return              SVG elements
std::string draw_bar(double drawn_width, const ColourMap& map, const ValueRange& range,
                     const std::string& label, const std::string& style = {});

/// @}

}  // namespace stokesbook::picture_parts
