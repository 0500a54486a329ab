#pragma once

#include <string>

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Replaces the characters that HTML reserves.
std::string escaped(const std::string& text);

/// Returns a number of three digits as a page shows it, powers of ten as such: 1.3·10⁻¹².
std::string html_number(double x);

/// @}

}  // namespace stokesbook::study
