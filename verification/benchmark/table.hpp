#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace stokesbook {

/// Numbers under named columns; the first column says what a row is about.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  std::string note;  ///< printed below; may be empty
};

/// Prints a table in aligned columns.
void print(std::ostream& out, const Table& table);

/// Writes tables as CSV, one number a line: table, first column's name and value, column, value.
void write_csv(std::ostream& out, const std::vector<Table>& tables);

}  // namespace stokesbook
