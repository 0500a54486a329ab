// Writes numbers as text by std::to_chars, which does not depend on the locale.
#include "text/number_text.hpp"

#include <algorithm>

namespace stokesbook {

std::string exact_number(double x) {
  return number_text(x, std::chars_format::general, 17);
}

std::string short_number(double x, int digits) {
  return number_text(x + 0.0, std::chars_format::general, digits);  // -0 becomes 0
}

std::string padded_number(std::size_t number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

}  // namespace stokesbook
