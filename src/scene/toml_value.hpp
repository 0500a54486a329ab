#pragma once

#include <concepts>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

/// Functions that write values in TOML's syntax.
namespace stokesbook::scene_text {

/// Writes a number as the shortest float that restores it exactly.
///
/// @param  number  any number; infinities and not a number are allowed
/// @return         `1.0`
std::string toml_value(double number);

/// Writes a vector as [x, y].
///
/// @param  vector  plane vector
/// @return         `[1.0, 2.0]`
std::string toml_value(Complex vector);

/// Writes a matrix as the list of its rows.
///
/// @param  matrix  its rows become lists
/// @return         `[[1.0, 2.0], [3.0, 4.0]]`
std::string toml_value(const Eigen::Matrix2d& matrix);

/// Writes text in double quotes.
///
/// @param  text  any text; quotes, backslashes and control characters are escaped
/// @return       `"text"`
std::string toml_value(std::string_view text);

/// Writes an integer, or true or false.
///
/// @param  value  number or Boolean
/// @return        `12` or `true`
std::string toml_value(std::integral auto value) {
  if constexpr (std::same_as<decltype(value), bool>) {
    return value ? "true" : "false";
  } else {
    return std::to_string(value);
  }
}

/// Writes a shape, `{ kind = "circle", radius = 1.0 }`.
///
/// @param  shape  any shape; the points of nodal curves are written out
/// @return        an inline table
std::string toml_value(const Shape& shape);

/// Writes a motion, `{ kind = "rotating", omega = 1.0 }`.
///
/// @param  motion  any motion
/// @return         an inline table
std::string toml_value(const WallMotion& motion);

/// Writes numbers as [a, b, ...].
///
/// @param  numbers  any numbers
/// @return          a list of floats
std::string toml_value(std::span<const double> numbers);

/// Writes points as [[x, y], ...].
///
/// @param  points  plane vectors
/// @return         a list of lists
std::string toml_value(const ComplexVector& points);

/// Writes formats as ["csv", ...].
///
/// @param  formats  any formats
/// @return          a list of words
std::string toml_value(const std::vector<OutputFormat>& formats);

/// Writes quantities as ["velocity", ...].
///
/// @param  quantities  any quantities
/// @return             a list of words
std::string toml_value(const std::vector<FieldQuantity>& quantities);

/// An entry of a table, the text `key = value`.
struct Entry {
  /// Writes an entry.
  /// @param  key    its name, which needs no quotation marks
  /// @param  value  anything that toml_value() writes
  template <class T>
  Entry(std::string_view key, const T& value)
      : text(std::string(key) + " = " + toml_value(value)) {}

  std::string text;  ///< text without an end of line
};

/// Writes entries, one on each line.
///
/// @param  entries  entries in order
/// @return          lines, each with an end of line
std::string lines(std::initializer_list<Entry> entries);

/// Writes entries as an inline table.
///
/// @param  entries  entries in order
/// @return          `{ key = value, ... }`
std::string inline_table(std::initializer_list<Entry> entries);

}  // namespace stokesbook::scene_text
