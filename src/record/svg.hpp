#pragma once

#include <string>

#include "trapezoid/plane.hpp"

/// Pieces of SVG text. Points are pixels, which count downwards.
namespace stokesbook::svg {

/// @addtogroup record
/// @{

/// Writes a number to two decimals, without trailing zeros.
///
/// @param  x  finite
/// @return    its text; never "-0"
std::string number(double x);

/// Writes a number as an attribute.
///
/// @param  name  of the attribute
/// @param  x     its value
/// @return       `name="x"` with a blank before it
std::string attribute(const std::string& name, double x);

/// Draws a straight line.
///
/// @param  from  first point, pixels
/// @param  to    last point, pixels
/// @return       path data
std::string line(Complex from, Complex to);

/// Draws an open line through points.
///
/// @param  points  in order, pixels
/// @return         path data
std::string polyline(const ComplexVector& points);

/// Draws a closed polygon.
///
/// @param  points  its corners in order, pixels
/// @return         path data
std::string polygon(const ComplexVector& points);

/// Makes a path element.
///
/// @param  data   path data
/// @param  style  its other attributes
/// @return        the element; empty for no data
std::string path(const std::string& data, const std::string& style);

/// Makes a text element.
///
/// @param  start  of the text's line, unless the style anchors it otherwise, pixels
/// @param  text   any; it is escaped
/// @param  style  its other attributes
/// @return        the element
std::string label(Complex start, const std::string& text, const std::string& style = {});

/// Opens a picture whose `currentColor` fits light and dark ground.
///
/// @param  size   width and height, pixels
/// @param  title  for screen readers; it is escaped
/// @return        the opening tag with title and style; `</svg>` closes it
std::string open(Complex size, const std::string& title);

/// @}

}  // namespace stokesbook::svg
