#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace stokesbook {

/// Writes a scene file that needs no other file: `parse_scene(to_toml(file), ...)` equals `file`,
/// bit for bit. Points of nodal curves are written out.
/// @param  file  a valid scene file, as parse_scene() returns it
std::string to_toml(const SceneFile& file);

}  // namespace stokesbook

namespace stokesbook::scene_text {

/// Writes a number as the shortest float that restores it exactly, `1.0`.
std::string toml_value(double number);

/// Writes text in double quotes, in which quotes, backslashes and control characters are escaped.
std::string toml_value(std::string_view text);

/// Writes an integer, or true or false.
std::string toml_value(std::integral auto value) {
  if constexpr (std::same_as<decltype(value), bool>) {
    return value ? "true" : "false";
  } else {
    return std::to_string(value);
  }
}

}  // namespace stokesbook::scene_text
