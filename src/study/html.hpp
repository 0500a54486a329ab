#pragma once

#include <string>

namespace stokesbook::study {

/// Replaces the characters that HTML reserves.
std::string escaped(const std::string& text);

/// Writes a number as HTML with three digits, with powers of ten as in 1.3·10⁻¹². Whole numbers
/// below a million keep all their digits; NaN becomes a dash.
std::string html_number(double x);

}  // namespace stokesbook::study
