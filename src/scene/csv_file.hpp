#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "scene/csv_table.hpp"
#include "scene/rules.hpp"

namespace stokesbook::scene_text {

/// Rule for a key that names a CSV file.
inline constexpr Requirement<std::string> csv_file_name{"the name of a CSV file"};

/// Reads the CSV file that a value of the scene names.
///
/// @param  name       path relative to the directory, or absolute
/// @param  directory  folder of the scene file
/// @param  headers    accepted header lines
/// @return            the table, with at least one row
/// @throws SceneError when the file cannot be read, or as parse_csv() does
CsvTable read_csv_file(const Node& name, const std::filesystem::path& directory,
                       std::initializer_list<std::string_view> headers);

}  // namespace stokesbook::scene_text
