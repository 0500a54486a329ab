#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace stokesbook::scene_text {

/// Returns what is in a file, or nothing when it cannot be read.
std::optional<std::string> text_of(const std::filesystem::path& path);

}  // namespace stokesbook::scene_text
