// Hashes a text by FNV-1a: hash <- (hash xor byte) * prime mod 2^64.
#include "text/fingerprint.hpp"

#include <array>
#include <charconv>
#include <cstdint>

namespace stokesbook {

std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.begin(), digits.end(), hash, 16);
  const auto count = static_cast<std::size_t>(end.ptr - digits.begin());
  return std::string(digits.size() - count, '0').append(digits.begin(), count);
}

}  // namespace stokesbook
