// Reads a whole text file into memory.
#include "scene/text_file.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

namespace stokesbook::scene_text {

std::optional<std::string> text_of(const std::filesystem::path& path) {
  // A stream can open a directory, so directories are refused first.
  std::error_code none_or_denied;
  if (std::filesystem::is_directory(path, none_or_denied)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return std::nullopt;
  return text.str();
}

}  // namespace stokesbook::scene_text
