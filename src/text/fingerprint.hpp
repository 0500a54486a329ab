#pragma once

#include <string>
#include <string_view>

namespace stokesbook {

/// Returns the 64-bit FNV-1a hash of a text as 16 hexadecimal digits. The hash detects accidental
/// changes, but not forgeries.
std::string fingerprint(std::string_view text);

}  // namespace stokesbook
