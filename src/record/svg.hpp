#pragma once

#include <string>

#include "trapezoid/plane.hpp"

/// Pieces of SVG text. Points are pixels, which count downwards.
namespace stokesbook::svg {

/// @addtogroup record
/// @{

/// Returns x to two decimals, without trailing zeros.
std::string number(double x);

/// Returns a number as an attribute, `name="x"` with a blank before it.
std::string attribute(const std::string& name, double x);

/// Returns the path data of a straight line.
std::string line(Complex from, Complex to);

/// Returns the path data of a closed polygon.
std::string polygon(const ComplexVector& points);

/// Returns a path element, nothing for no data; `style` holds its other attributes.
std::string path(const std::string& data, const std::string& style);

/// Returns a text element that starts at a point.
std::string label(Complex start, const std::string& text, const std::string& style = {});

/// Opens a picture of that size whose `currentColor` fits light and dark ground.
std::string open(Complex size, const std::string& title);

/// @}

}  // namespace stokesbook::svg
