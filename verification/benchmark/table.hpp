#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace stokesbook {

/// Holds numbers in named columns. The first column identifies the row.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  std::string note;        ///< printed below; may be empty
  std::string drawn = {};  ///< label of the figure's ordinate; empty: no figure
  std::size_t first = 1;   ///< the first column of the figure
  std::size_t last = 1;    ///< the last column of the figure
};

/// Prints a table in aligned columns.
void print(std::ostream& out, const Table& table);

/// Writes tables and their figures for a page of the book, as HTML.
void write_page(std::ostream& out, const std::string& machine, const std::vector<Table>& tables);

/// Writes tables as CSV. Each line holds one number: the table, the name and the value of the first
/// column, the name of the number's column, and the number.
void write_csv(std::ostream& out, const std::vector<Table>& tables);

}  // namespace stokesbook
