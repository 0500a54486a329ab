#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace stokesbook {

/// Returns the bytes of a file; none if the file cannot be read.
std::optional<std::string> read_text_file(const std::filesystem::path& path);

}  // namespace stokesbook
