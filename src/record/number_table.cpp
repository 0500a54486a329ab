// Reads tables of numbers, which csv.cpp has written, by columns.
#include "record/number_table.hpp"

#include <algorithm>

#include "record/atomic_file.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

const std::vector<double>& NumberTable::operator[](std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw RecordError(path, "has no column '" + std::string(name) + "'");
  return columns[static_cast<std::size_t>(found - names.begin())];
}

NumberTable read_table(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  NumberTable table{path, {}, {}};
  for (const std::string_view line : split(text, '\n')) {
    if (line.empty()) continue;  // the end of the file
    const std::vector<std::string_view> cells = split(line, ',');
    if (table.names.empty()) {
      table.names.assign(cells.begin(), cells.end());
      table.columns.resize(cells.size());
      continue;
    }
    if (cells.size() != table.names.size()) throw RecordError(path, "has a row that is not whole");
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto number = parse_number<double>(cells[k]);
      if (!number) {
        throw RecordError(path, "holds '" + std::string(cells[k]) + "' where a number should be");
      }
      table.columns[k].push_back(*number);
    }
  }
  return table;
}

}  // namespace stokesbook
