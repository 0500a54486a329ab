#pragma once

#include <string>

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Replaces the characters that HTML reserves.
///
/// @param  text  any text
/// @return       the same as HTML shows it
std::string escaped(const std::string& text);

/// Writes a number of three digits for a page, powers of ten as such: 1.3·10⁻¹². Whole numbers
/// below a million keep all of theirs.
///
/// @param  x  a number; NaN is a dash
/// @return    HTML
std::string html_number(double x);

/// @}

}  // namespace stokesbook::study
