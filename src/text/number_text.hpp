#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace stokesbook {

/// Appends a number with 17 significant digits, which restore it exactly, whatever the locale;
/// `inf` and `nan` are numbers, too.
void append_number(std::string& text, double x);

/// Appends an integer.
void append_number(std::string& text, std::integral auto n) {
  text += std::to_string(n);
}

/// Writes a rounded number for messages and pictures.
/// The text has at most so many significant digits, and no trailing zeros: `0.0125`, `1.25e-10`.
std::string short_number(double x, int digits = 3);

}  // namespace stokesbook
