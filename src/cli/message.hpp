#pragma once

#include <string>
#include <string_view>

namespace stokesbook {

/// Makes text from a file or an argument safe to be shown on a terminal.
///
/// A terminal would obey control characters, and a value may be as long as a file.
/// @param  text  of any length, with any bytes
/// @return       the text on one line, with control characters and bytes that are not UTF-8 in the
///               form `\x1b`; a text of more than 2000 bytes is cut to its first 1200 and last 700
std::string for_terminal(std::string_view text);

}  // namespace stokesbook
