#pragma once

#include <concepts>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

/// Values in TOML's syntax.
namespace stokesbook::scene_text {

/// Writes a number as the shortest float that gives it back exactly.
std::string toml_value(double number);

/// Writes [x, y].
std::string toml_value(Complex vector);

/// Writes [[a, b], [c, d]].
std::string toml_value(const Eigen::Matrix2d& matrix);

/// Writes text in double quotes.
std::string toml_value(std::string_view text);

/// Writes an integer, or true or false.
std::string toml_value(std::integral auto value) {
  if constexpr (std::same_as<decltype(value), bool>) {
    return value ? "true" : "false";
  } else {
    return std::to_string(value);
  }
}

/// Writes { kind = "circle", radius = 1.0 }; points of nodal curves are written out.
std::string toml_value(const Shape& shape);

/// Writes { kind = "rotating", omega = 1.0 }.
std::string toml_value(const WallMotion& motion);

/// Writes [a, b, ...].
std::string toml_value(std::span<const double> numbers);

/// Writes [[x, y], ...].
std::string toml_value(const ComplexVector& points);

/// Writes ["csv", ...].
std::string toml_value(const std::vector<OutputFormat>& formats);

/// `key = value`
struct Entry {
  template <class T>
  Entry(std::string_view key, const T& value)
      : text(std::string(key) + " = " + toml_value(value)) {}

  std::string text;
};

/// Writes entries one a line.
std::string lines(std::initializer_list<Entry> entries);

/// Writes { key = value, ... }.
std::string inline_table(std::initializer_list<Entry> entries);

}  // namespace stokesbook::scene_text
