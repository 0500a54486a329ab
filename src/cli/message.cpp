// Makes messages safe to print, since messages quote text from scenes and arguments: escapes
// control characters and invalid UTF-8, and shortens long texts.
#include "cli/message.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace stokesbook {

namespace {

constexpr std::size_t longest = 2000, kept_of_start = 1200, kept_of_end = 700;

// Returns the number of bytes of the UTF-8 character at the start of a text; 0 for invalid bytes,
// and for control characters, which a terminal would obey.
std::size_t shown_bytes(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t count = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < count) return 0;
  for (std::size_t k = 1; k < count; ++k) {
    if ((byte(k) & 0xc0U) != 0x80U) return 0;
  }
  return first == 0xc2 && byte(1) < 0xa0 ? 0 : count;
}

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t bytes = shown_bytes(text);
    if (bytes > 0) {
      result += text.substr(0, bytes);
    } else {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\x%02x", static_cast<unsigned char>(text[0]));
      result += text[0] == '\n' ? "\\n" : text[0] == '\t' ? "\\t" : code.data();
    }
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

}  // namespace

std::string for_terminal(std::string_view text) {
  if (text.size() <= longest) return escaped(text);
  return escaped(text.substr(0, kept_of_start)) + " ... " +
         escaped(text.substr(text.size() - kept_of_end));
}

}  // namespace stokesbook
