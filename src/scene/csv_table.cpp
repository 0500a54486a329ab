// Parses the text of a CSV file into a table of numbers: one header line, then rows of numbers.
#include "scene/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "text/text_file.hpp"
#include "text/word_list.hpp"

namespace stokesbook::scene_text {

namespace {

std::string_view trim(std::string_view text) {
  constexpr std::string_view space = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
  return text.substr(0, text.find_last_not_of(space) + 1);
}

double read_number(std::string_view field, std::string_view column, const std::string& where) {
  const bool has_plus = field.starts_with('+') && !field.starts_with("+-");
  const std::string_view digits = field.substr(has_plus ? 1 : 0);
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, status] = std::from_chars(digits.data(), end, value);
  if (status == std::errc::result_out_of_range) {
    value = std::strtod(std::string(digits).c_str(), nullptr);  // 0 or infinity
  }
  if (status == std::errc::invalid_argument || stop != end ||
      !(std::abs(value) <= largest_number)) {
    throw SceneError(where + ": " + std::string(column) + " = " + std::string(field) +
                     ": must be a number with magnitude at most 1e100");
  }
  return value;
}

CsvRow parse_row(std::string_view line, const std::vector<std::string>& columns,
                 const std::string& where) {
  const std::vector<std::string_view> fields = split(line, ',');
  if (fields.size() != columns.size()) {
    throw SceneError(where + ": must hold " + std::to_string(columns.size()) + " values (" +
                     joined(columns, ",") + "), not " + std::to_string(fields.size()));
  }
  CsvRow row{where, {}};
  for (std::size_t k = 0; k < fields.size(); ++k) {
    row.values.push_back(read_number(trim(fields[k]), columns[k], where));
  }
  return row;
}

}  // namespace

bool CsvTable::has(std::string_view column) const {
  return std::ranges::find(columns, column) != columns.end();
}

std::optional<double> CsvTable::value(const CsvRow& row, std::string_view column) const {
  const auto found = std::ranges::find(columns, column);
  if (found == columns.end()) return {};
  return row.values[static_cast<std::size_t>(found - columns.begin())];
}

CsvTable parse_csv(std::string_view text, const std::string& file_name, const CsvHeader& header) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // spreadsheets write this mark
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  CsvTable table;
  std::size_t line_number = 0;
  for (const std::string_view raw : split(text, '\n')) {
    const std::string where = file_name + ":" + std::to_string(++line_number);
    const std::string_view line = trim(raw.substr(0, raw.find('#')));
    if (line.empty()) continue;
    if (!table.columns.empty()) {
      table.rows.push_back(parse_row(line, table.columns, where));
      continue;
    }
    for (const std::string_view name : split(line, ',')) table.columns.emplace_back(trim(name));
    const bool is_valid = header.accepts != nullptr ? header.accepts(table.columns)
                                                    : joined(table.columns, ",") == header.expected;
    if (!is_valid) {
      throw SceneError(where + ": header = " + std::string(line) + ": must be " +
                       std::string(header.expected));
    }
  }
  if (table.rows.empty()) {
    throw SceneError(file_name + ": must hold rows of numbers below the header " +
                     std::string(header.expected));
  }
  return table;
}

CsvTable read_csv_file(const Node& name, const std::filesystem::path& directory,
                       const CsvHeader& header) {
  const std::filesystem::path path = directory / read(name, csv_file_name);
  const std::optional<std::string> text = read_text_file(path);
  if (!text) fail(name, "the file " + path.string() + " does not exist or cannot be read");
  return parse_csv(*text, path.string(), header);
}

}  // namespace stokesbook::scene_text
