#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace stokesbook {

/// @addtogroup record
/// @{

/// Appends a number with 17 significant digits, which restore it exactly, whatever the locale.
///
/// @param  text  text to which the number is appended
/// @param  x     any number, `inf` and `nan` included
void append_number(std::string& text, double x);

/// Appends an integer.
///
/// @param  text  text to which the integer is appended
/// @param  n     any integer
void append_number(std::string& text, std::integral auto n) {
  text += std::to_string(n);
}

/// Writes a rounded number for messages and pictures.
///
/// @param  x       any number
/// @param  digits  largest number of significant digits
/// @return         text without trailing zeros, `0.0125` or `1.25e-10`
std::string short_number(double x, int digits = 3);

/// @}

}  // namespace stokesbook
