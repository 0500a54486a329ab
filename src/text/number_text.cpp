// Writes numbers as text by std::to_chars, which does not depend on the locale.
#include "text/number_text.hpp"

#include <algorithm>
#include <array>

namespace stokesbook {

namespace {

std::string general(double x, int digits) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x,
                                 std::chars_format::general, digits);
  return {buffer.data(), end.ptr};
}

}  // namespace

void append_number(std::string& text, double x) {
  text += general(x, 17);
}

std::string short_number(double x, int digits) {
  return general(x + 0.0, digits);  // -0 becomes 0
}

std::string padded_number(std::size_t number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

}  // namespace stokesbook
