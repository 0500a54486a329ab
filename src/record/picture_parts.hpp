#pragma once

#include <string>

#include "record/colour_map.hpp"
#include "record/picture.hpp"

/// What the pictures of a run have in common. Points and lengths are pixels.
namespace stokesbook::picture_parts {

/// @addtogroup record
/// @{

/// @name Layout
/// @{
inline constexpr double margin = 14.0;       ///< around the picture
inline constexpr double header = 54.0;       ///< title and time, above the drawing
inline constexpr double bar_column = 84.0;   ///< colour bar and its numbers, right of the drawing
inline constexpr double bar_height = 150.0;  ///< also the least height of a drawing
/// @}

/// Returns the scale that makes a drawing fill its column, but not much higher than wide.
///
/// @param  size   width and height of what is drawn, length
/// @param  width  of the whole picture
/// @return        pixels a length
double scale_of_drawing(Complex size, double width);

/// Opens a picture and writes title and time above the drawing.
///
/// @param  drawn    width and height of the drawing
/// @param  t        time
/// @param  options  title, and the width that it may need
/// @return          all but what is drawn; `</svg>` closes it
std::string open_picture(Complex drawn, double t, const PictureOptions& options);

/// Values at the ends of a colour bar.
struct ValueRange {
  double low,  ///< of the first colour
      high;    ///< of the last
};

/// Draws the colours of values, right of the drawing, with numbers.
///
/// @param  drawn_width  of the drawing
/// @param  map          of the colours
/// @param  range        values at both ends
/// @param  label        above the bar
/// @param  style        other attributes of the bar
/// @return              elements
std::string draw_bar(double drawn_width, const ColourMap& map, const ValueRange& range,
                     const std::string& label, const std::string& style = {});

/// @}

}  // namespace stokesbook::picture_parts
