// Reads a whole text file into memory.
#include "text/text_file.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

namespace stokesbook {

std::optional<std::string> read_text_file(const std::filesystem::path& path) {
  // A stream can open a directory, so directories are refused first.
  std::error_code none_or_denied;
  if (std::filesystem::is_directory(path, none_or_denied)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return std::nullopt;
  return text.str();
}

}  // namespace stokesbook
