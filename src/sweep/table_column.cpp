// Reads a column of a run's table and reduces it to one number, averages by the trapezoid rule.
#include "sweep/table_column.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/record_error.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

struct Column {
  std::vector<double> t, y;
};

double number_in(std::string_view cell, const std::filesystem::path& path) {
  double number = 0.0;
  const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (status != std::errc{} || end != cell.data() + cell.size()) {
    throw RecordError(path, "holds '" + std::string(cell) + "' where a number should be");
  }
  return number;
}

/// Reads the first column, which is time, and the column of a quantity. If the quantity has an
/// item, only rows with this item in their second column are read.
Column read_column(const std::filesystem::path& path, const Quantity& quantity) {
  const std::string text = read_text(path);
  const std::vector<std::string_view> lines = split(text, '\n');
  const std::vector<std::string_view> header = split(lines.front(), ',');
  const auto found = std::ranges::find(header, quantity.column);
  if (found == header.end()) throw RecordError(path, "has no column '" + quantity.column + "'");
  const auto k = static_cast<std::size_t>(found - header.begin());
  Column column;
  for (const std::string_view line : std::span(lines).subspan(1)) {
    if (line.empty()) continue;  // the end of the file
    const std::vector<std::string_view> cells = split(line, ',');
    if (cells.size() != header.size()) throw RecordError(path, "has a row that is not whole");
    if (quantity.item && number_in(cells[1], path) != *quantity.item) continue;
    column.t.push_back(number_in(cells[0], path));
    column.y.push_back(number_in(cells[k], path));
  }
  return column;
}

}  // namespace

double time_average(std::span<const double> t, std::span<const double> y, double from, double to) {
  if (to > t.back()) {
    throw std::invalid_argument("ends at t = " + short_number(t.back(), 17) +
                                ", before the average over [" + short_number(from, 17) + ", " +
                                short_number(to, 17) + "]");
  }
  double integral = y[0] * std::max(0.0, std::min(to, t[0]) - from);
  for (std::size_t k = 1; k < t.size(); ++k) {
    const double begin = std::max(from, t[k - 1]);
    const double end = std::min(to, t[k]);
    if (begin >= end) continue;
    // The interpolant is linear here: the integral is the length times the value at the midpoint.
    const double s = (0.5 * (begin + end) - t[k - 1]) / (t[k] - t[k - 1]);
    integral += (end - begin) * std::lerp(y[k - 1], y[k], s);
  }
  return integral / (to - from);
}

double value_of(const std::filesystem::path& run, const Quantity& quantity) {
  const std::filesystem::path path = run / quantity.table;
  const auto [t, y] = read_column(path, quantity);
  if (y.empty()) {
    throw RecordError(path, quantity.item ? "has no row of number " + std::to_string(*quantity.item)
                                          : "has no rows");
  }
  switch (quantity.reduction) {
    case Reduction::average:
      try {
        return time_average(t, y, quantity.from, quantity.to);
      } catch (const std::invalid_argument& error) {
        throw RecordError(path, error.what());
      }
    case Reduction::last:
      return y.back();
    case Reduction::least:
      return std::ranges::min(y);
    case Reduction::largest:
      return std::ranges::max(y);
    case Reduction::sum:
      return std::accumulate(y.begin(), y.end(), 0.0);
  }
  throw std::logic_error("a reduction without a value");
}

}  // namespace stokesbook
