#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stokesbook {

/// Writes a number by std::to_chars, which does not depend on the locale.
/// @param  format  format and precision of std::to_chars; by default, the text is the shortest one
///                 that restores the number
std::string number_text(double x, auto... format) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.begin(), buffer.end(), x, format...);
  return {buffer.begin(), end.ptr};
}

/// Writes a number with 17 significant digits, which restore it exactly; `inf` and `nan` are
/// numbers, too.
std::string exact_number(double x);

/// Writes an integer.
std::string exact_number(std::integral auto n) {
  return std::to_string(n);
}

/// Writes a number for messages and pictures, rounded to a number of significant digits and without
/// trailing zeros: `0.0125`, `1.25e-10`.
std::string short_number(double x, int digits = 3);

/// Writes an integer with at least the given number of digits, led by zeros: `0007`.
std::string padded_number(std::size_t number, std::size_t digits);

/// Reads a number from a text that contains nothing else; none for other texts.
/// @param  format  std::chars_format of a floating-point number, general by default
template <class Number>
std::optional<Number> parse_number(std::string_view text, auto... format) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number, format...);
  return error == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

}  // namespace stokesbook
