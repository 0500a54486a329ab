#pragma once

#include <string>
#include <string_view>

namespace stokesbook {

/// Makes text of a file or an argument fit to be shown on a terminal.
///
/// Control characters would be obeyed there, and a value may be as long as a file.
/// @param  text  of any length, with any bytes
/// @return       the same on one line, with control characters and bytes that are no UTF-8 as
///               `\x1b`; of more than 2000 bytes the first 1200 and the last 700
std::string for_terminal(std::string_view text);

}  // namespace stokesbook
