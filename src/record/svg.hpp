#pragma once

#include <string>

#include "trapezoid/plane.hpp"

/// Functions that write pieces of SVG text. Points are in pixels, with y downwards.
namespace stokesbook::svg {

/// @addtogroup record
/// @{

/// Writes a number rounded to two decimals, without trailing zeros.
///
/// @param  x  a finite number
/// @return    its text, never "-0"
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
/// @return        the element; empty if there are no data
std::string path(const std::string& data, const std::string& style);

/// Makes a text element.
///
/// @param  start  start of the text, or another anchor that the style sets, pixels
/// @param  text   any text, which is escaped
/// @param  style  its other attributes
/// @return        the element
std::string label(Complex start, const std::string& text, const std::string& style = {});

/// Opens a picture whose `currentColor` suits light and dark backgrounds.
///
/// @param  size   width and height, pixels
/// @param  title  title for screen readers, which is escaped
/// @return        the opening tag with title and style; `</svg>` closes it
std::string open(Complex size, const std::string& title);

/// @}

}  // namespace stokesbook::svg
