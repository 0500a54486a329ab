#pragma once

#include <string>
#include <string_view>

namespace stokesbook::scene_text {

/// Joins words into one text.
///
/// @param  words      a range of texts
/// @param  separator  text between two words
/// @return            the words in order, "euler, heun"
std::string joined(const auto& words, std::string_view separator = ", ") {
  std::string text;
  bool first = true;
  for (const std::string_view word : words) {
    if (!first) text += separator;
    text += word;
    first = false;
  }
  return text;
}

}  // namespace stokesbook::scene_text
