#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace stokesbook::scene_text {

/// One line of numbers.
struct CsvRow {
  std::string where;           ///< "bodies.csv:7"
  std::vector<double> values;  ///< finite, as many as there are columns
};

/// Numbers in named columns.
struct CsvTable {
  std::string header;        ///< without blanks, "x,y,theta"
  std::vector<CsvRow> rows;  ///< in file order
};

/// Splits a text.
///
/// @param  text       any
/// @param  separator  that parts end with, all but the last
/// @return            views of the text
std::vector<std::string_view> split(std::string_view text, char separator);

/// Parses comma-separated numbers below a header line. Blank lines and comments (`#` to the end of
/// the line) do not count; lines end in LF or CRLF.
///
/// @param  text       of the file
/// @param  file_name  what messages call it
/// @param  headers    those that are right
/// @return            the table, with at least one row
/// @throws SceneError naming file, line, and the column and value if they are at fault
CsvTable parse_csv(std::string_view text, const std::string& file_name,
                   std::initializer_list<std::string_view> headers);

}  // namespace stokesbook::scene_text
