#pragma once

#include <string>
#include <string_view>

namespace stokesbook {

/// Makes text from a file or an argument safe to be shown on a terminal, which would obey control
/// characters.
/// @return  the text on one line, with control characters and bytes that are not UTF-8 in the form
///          `\x1b`; a text of more than 2000 bytes is cut to its first 1200 and last 700
std::string for_terminal(std::string_view text);

}  // namespace stokesbook
