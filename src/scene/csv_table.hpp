#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace stokesbook::scene_text {

/// A row of a CSV table.
struct CsvRow {
  std::string where;           ///< file and line for messages, "bodies.csv:7"
  std::vector<double> values;  ///< finite numbers, one for each column
};

/// A CSV table: numbers in named columns.
struct CsvTable {
  std::string header;        ///< without blanks, "x,y,theta"
  std::vector<CsvRow> rows;  ///< in file order
};

/// Splits a text at every separator.
///
/// @param  text       any text
/// @param  separator  the character between two parts
/// @return            the parts, one more than the text has separators; views of the text
std::vector<std::string_view> split(std::string_view text, char separator);

/// Parses comma-separated numbers below a header line. Blank lines and comments (`#` to the end of
/// the line) are skipped; lines end in LF or CRLF.
///
/// @param  text       contents of the file
/// @param  file_name  name of the file in messages
/// @param  headers    accepted header lines
/// @return            the table, with at least one row
/// @throws SceneError that names the file, the line, and the column and value if these are wrong
CsvTable parse_csv(std::string_view text, const std::string& file_name,
                   std::initializer_list<std::string_view> headers);

}  // namespace stokesbook::scene_text
