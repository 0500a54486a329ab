#include "table.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace stokesbook {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

void print(std::ostream& out, const Table& table) {
  out << '\n' << table.title << '\n';
  const auto cell = [&](const std::string& text, std::size_t column) {
    const std::size_t width = std::max<std::size_t>(table.columns[column].size(), 9) + 2;
    out << std::string(width - std::min(width, text.size()), ' ') << text;
  };
  for (std::size_t c = 0; c < table.columns.size(); ++c) cell(table.columns[c], c);
  out << '\n';
  for (const std::vector<double>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) cell(number(row[c]), c);
    out << '\n';
  }
  if (!table.note.empty()) out << table.note << '\n';
  out << std::flush;
}

void write_csv(std::ostream& out, const std::vector<Table>& tables) {
  out << "table,key,key_value,quantity,value\n";
  for (const Table& table : tables) {
    for (const std::vector<double>& row : table.rows) {
      for (std::size_t c = 1; c < row.size(); ++c) {
        out << '"' << table.title << "\"," << table.columns[0] << ',' << number(row[0]) << ','
            << table.columns[c] << ',' << number(row[c]) << '\n';
      }
    }
  }
}

}  // namespace stokesbook
