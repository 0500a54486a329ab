#pragma once

#include <string>

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Replaces the characters that HTML reserves.
///
/// @param  text  any text
/// @return       HTML that shows the text
std::string escaped(const std::string& text);

/// Writes a number with three digits for a page, with powers of ten as in 1.3·10⁻¹². Whole numbers
/// below a million keep all their digits.
///
/// @param  x  a number; NaN becomes a dash
/// @return    HTML
std::string html_number(double x);

/// @}

}  // namespace stokesbook::study
