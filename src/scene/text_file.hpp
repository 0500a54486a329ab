#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace stokesbook::scene_text {

/// Returns the contents of a file.
///
/// @param  path  path of the file
/// @return       its bytes; none when it cannot be read
std::optional<std::string> text_of(const std::filesystem::path& path);

}  // namespace stokesbook::scene_text
