// Writes text and numbers as HTML.
#include "study/html.hpp"

#include <cmath>

#include "text/number_text.hpp"

namespace stokesbook::study {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  }
  return result;
}

std::string html_number(double x) {
  if (std::isnan(x)) return "&ndash;";
  const bool is_count = x == std::floor(x) && std::abs(x) < 1e6;
  const std::string text = short_number(x, is_count ? 6 : 3);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return text.substr(0, e) + "&middot;10<sup>" + std::to_string(std::stoi(text.substr(e + 1))) +
         "</sup>";
}

}  // namespace stokesbook::study
