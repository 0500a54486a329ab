// Hashes a text by FNV-1a: hash <- (hash xor byte) * prime mod 2^64.
#include "text/fingerprint.hpp"

#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

namespace stokesbook {

std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016" PRIx64, hash);
  return digits.data();
}

}  // namespace stokesbook
