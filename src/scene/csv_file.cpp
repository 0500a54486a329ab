// Reads a CSV file that a key of the scene names, relative to the folder of the scene.
#include "scene/csv_file.hpp"

#include <optional>

#include "text/text_file.hpp"

namespace stokesbook::scene_text {

CsvTable read_csv_file(const Node& name, const std::filesystem::path& directory,
                       std::initializer_list<std::string_view> headers) {
  const std::filesystem::path path = directory / read(name, csv_file_name);
  const std::optional<std::string> text = read_text_file(path);
  if (!text) fail(name, "the file " + path.string() + " does not exist or cannot be read");
  return parse_csv(*text, path.string(), headers);
}

}  // namespace stokesbook::scene_text
