#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/table_reader.hpp"

namespace stokesbook::scene_text {

/// A row of a CSV table.
struct CsvRow {
  std::string where;           ///< file and line for messages, "bodies.csv:7"
  std::vector<double> values;  ///< finite numbers, one for each column
};

/// A CSV table: numbers in named columns.
struct CsvTable {
  std::vector<std::string> columns;  ///< names without blanks
  std::vector<CsvRow> rows;          ///< at least one, in file order

  /// Returns whether the table has a column.
  bool has(std::string_view column) const;

  /// Returns the value of a row in a column; none if the table has no such column.
  std::optional<double> value(const CsvRow& row, std::string_view column) const;
};

/// Rule for the header line of a CSV table.
struct CsvHeader {
  std::string_view expected;  ///< completes "must be ..."
  /// Returns whether columns are valid; null: they must be the expected ones, such as "x,y".
  bool (*accepts)(const std::vector<std::string>&) = nullptr;
};

/// Parses comma-separated numbers below a header line that the rule accepts. Blank lines and
/// comments (`#` to the end of the line) are skipped; lines end in LF or CRLF.
/// @throws SceneError that names the file, the line, and the column and value if these are wrong
CsvTable parse_csv(std::string_view text, const std::string& file_name, const CsvHeader& header);

/// Rule for a key that names a CSV file.
inline constexpr Requirement<std::string> csv_file_name{"the name of a CSV file"};

/// Reads the CSV file that a value of the scene names, relative to the folder of the scene file.
/// @throws SceneError when the file cannot be read, or as parse_csv() does
CsvTable read_csv_file(const Node& name, const std::filesystem::path& directory,
                       const CsvHeader& header);

}  // namespace stokesbook::scene_text
