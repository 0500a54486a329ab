// Prints benchmark tables, and writes them as HTML with figures and as CSV.
#include "table.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "study/plot.hpp"
#include "study/tables.hpp"

namespace stokesbook {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// Plots the drawn columns over the first column.
std::string figure(const Table& table) {
  study::Plot plot{.title = table.title, .x_label = table.columns[0], .y_label = table.drawn};
  for (std::size_t c = table.first; c <= table.last; ++c) {
    study::PlotLine line{.label = table.columns[c]};
    for (const std::vector<double>& row : table.rows) line.points.push_back({row[0], row[c]});
    plot.lines.push_back(std::move(line));
  }
  return study::draw_plot(plot);
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

void write_page(std::ostream& out, const std::string& machine, const std::vector<Table>& tables) {
  out << "<pre class=\"fragment\">" << study::escaped(machine) << "</pre>\n";
  for (const Table& table : tables) {
    out << "<div class=\"study-table\"><table>\n<caption>" << study::escaped(table.title)
        << "</caption>\n<tr>";
    for (const std::string& column : table.columns) {
      out << "<th>" << study::escaped(column) << "</th>";
    }
    out << "</tr>\n";
    for (const std::vector<double>& row : table.rows) {
      out << "<tr>";
      for (const double value : row) out << "<td>" << study::html_number(value) << "</td>";
      out << "</tr>\n";
    }
    out << "</table></div>\n";
    if (!table.note.empty()) out << "<p>" << study::escaped(table.note) << "</p>\n";
    if (!table.drawn.empty()) out << figure(table);
  }
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
