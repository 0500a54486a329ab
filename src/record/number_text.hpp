#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace stokesbook {

/// @addtogroup record
/// @{

/// Appends x with 17 significant digits, which restore it exactly, whatever the locale.
void append_number(std::string& text, double x);

/// Appends an integer.
void append_number(std::string& text, std::integral auto n) {
  text += std::to_string(n);
}

/// Returns x with at most the given number of significant digits, for people.
std::string short_number(double x, int digits = 3);

/// @}

}  // namespace stokesbook
