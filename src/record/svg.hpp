#pragma once

#include <array>
#include <string>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A colour map: colours for numbers from 0 to 1.
struct ColourMap {
  const char* name;            ///< one word
  std::array<int, 9> samples;  ///< equidistant, 0xrrggbb
};

/// The map viridis, dark to light with equal perceptual distances
/// (S. van der Walt and N. Smith, CC0).
inline constexpr ColourMap viridis{
    "viridis",
    {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725}};

/// A map for numbers with a sign: blue below zero, red above; zero is grey and lies at 0.5
/// (K. Moreland, Diverging Color Maps for Scientific Visualization, 2009).
inline constexpr ColourMap cool_to_warm{
    "cool-to-warm",
    {0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd, 0xf5c4ad, 0xf49a7b, 0xde604d, 0xb40426}};

/// Returns the colour `#rrggbb` of a fraction, by linear interpolation between the samples of a
/// map. Fractions outside [0, 1] have the colour of the nearer end.
std::string colour(const ColourMap& map, double fraction);

/// Functions that write pieces of SVG text. Points are in pixels, with y downwards.
namespace svg {

/// Escapes text for XML and HTML. Control characters become blanks, since XML does not allow them.
std::string escaped(const std::string& text);

/// Writes a finite number rounded to two decimals, without trailing zeros, and never as "-0".
std::string number(double x);

/// Writes an attribute with a number, `name="x"` with a blank before it.
std::string attribute(const std::string& name, double x);

/// Returns the path data of a straight line.
std::string line(Complex from, Complex to);

/// Returns the path data of an open line through points, at least one.
std::string polyline(const ComplexVector& points);

/// Returns the path data of a closed polygon.
std::string polygon(const ComplexVector& corners);

/// Makes a path element; empty if there are no data. The style contains the other attributes.
std::string path(const std::string& data, const std::string& style);

/// Makes a group of elements, which inherit the attributes of the style.
std::string group(const std::string& elements, const std::string& style);

/// Makes an element of any text, which is escaped. The style contains the other attributes.
/// @param  start  start of the text, or another anchor that the style sets
std::string label(Complex start, const std::string& text, const std::string& style = {});

/// Opens a picture whose `currentColor` suits light and dark backgrounds; `</svg>` closes it.
/// @param  size   width and height
/// @param  title  any text for screen readers, which is escaped
std::string open(Complex size, const std::string& title);

/// Makes a bar of all colours of a map, with the colour of 1 at its top.
/// @param  corner  upper left corner
/// @param  size    width and height
std::string colour_bar(const ColourMap& map, Complex corner, Complex size,
                       const std::string& style = {});

}  // namespace svg

}  // namespace stokesbook
