// Collects quantities from the finished runs of a sweep, each a column of a table reduced to one
// number, averages by the trapezoid rule, and writes their means over the seeds with error bars.
#include "sweep/results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <gsl/gsl_cdf.h>

#include "record/atomic_file.hpp"
#include "record/csv.hpp"
#include "sweep/sweep_folder.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

struct Column {
  std::vector<double> t, y;
};

/// Reads the first column, which is time, and the column of a quantity. If the quantity has an
/// item, only rows with this item in their second column are read.
Column read_column(const std::filesystem::path& path, const Quantity& quantity) {
  const NumberTable table = read_table(path);
  const std::vector<double>& y = table[quantity.column];
  Column column;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (quantity.item && table.columns[1][k] != *quantity.item) continue;
    column.t.push_back(table.columns[0][k]);
    column.y.push_back(y[k]);
  }
  return column;
}

/// Collects the runs of one combination, which differ only in their seeds.
ResultRow collect_row(const std::filesystem::path& out, const Sweep& sweep,
                      std::span<const Task> tasks) {
  ResultRow row;
  for (std::size_t k = 0; k < sweep.columns.size(); ++k) {
    row.values.push_back(tasks.front().settings[k].chosen.value);
  }
  std::vector<std::vector<double>> values(sweep.quantities.size());
  std::vector<MeanEstimate> latest(sweep.quantities.size());
  for (const Task& task : tasks) {
    const TaskFolder folder(out, task.number);
    const TaskState state = folder.state();
    if (state == TaskState::failed) ++row.failed;
    if (state == TaskState::unfinished) ++row.unfinished;
    if (state != TaskState::done) continue;
    ++row.runs;
    for (std::size_t j = 0; j < values.size(); ++j) {
      latest[j] = value_of(folder.path(), sweep.quantities[j]);
      values[j].push_back(latest[j].mean);
    }
  }
  for (std::size_t j = 0; j < values.size(); ++j) {
    row.estimates.push_back(row.runs == 1 ? latest[j] : estimate_mean(values[j]));
  }
  return row;
}

std::string with_error_bar(const MeanEstimate& estimate) {
  const std::string mean = short_number(estimate.mean, 6);
  return std::isnan(estimate.interval) ? mean : mean + " +- " + short_number(estimate.interval, 2);
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

MeanEstimate value_of(const std::filesystem::path& run, const Quantity& quantity) {
  const std::filesystem::path path = run / quantity.table;
  const auto [t, y] = read_column(path, quantity);
  if (y.empty()) {
    throw RecordError(path, quantity.item ? "has no row of number " + std::to_string(*quantity.item)
                                          : "has no rows");
  }
  const auto without_error = [](double value) { return MeanEstimate{value, undefined, undefined}; };
  switch (quantity.reduction) {
    case Reduction::average:
      try {
        return mean_over_time(t, y, quantity.from, quantity.to);
      } catch (const std::invalid_argument& error) {
        throw RecordError(path, error.what());
      }
    case Reduction::last:
      return without_error(y.back());
    case Reduction::least:
      return without_error(std::ranges::min(y));
    case Reduction::largest:
      return without_error(std::ranges::max(y));
    case Reduction::sum:
      return without_error(std::accumulate(y.begin(), y.end(), 0.0));
  }
  throw std::logic_error("a reduction without a value");
}

MeanEstimate estimate_mean(std::span<const double> values) {
  if (values.empty()) return {undefined, undefined, undefined};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() == 1) return {mean, undefined, undefined};
  // Standard error e = sqrt(sum_k (x_k - m)^2 / (n (n - 1))), half width t_{n-1}(0.975) e.
  double squares = 0.0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const double standard_error = std::sqrt(squares / (n * (n - 1.0)));
  return {mean, standard_error, gsl_cdf_tdist_Pinv(0.975, n - 1.0) * standard_error};
}

MeanEstimate mean_over_time(std::span<const double> t, std::span<const double> y, double from,
                            double to) {
  constexpr std::ptrdiff_t most_blocks = 32, least_blocks = 8;
  const double mean = time_average(t, y, from, to);
  const auto n = std::min(
      most_blocks, std::ranges::count_if(t, [&](double at) { return at >= from && at <= to; }));
  if (n < least_blocks || std::isnan(mean)) return {mean, undefined, undefined};
  const double count = static_cast<double>(n), length = (to - from) / count;
  double squares = 0.0, products = 0.0, before = 0.0;
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const double begin = from + static_cast<double>(k) * length;
    const double deviation = time_average(t, y, begin, std::min(begin + length, to)) - mean;
    squares += deviation * deviation;
    products += deviation * std::exchange(before, deviation);
  }
  if (squares == 0.0) return {mean, 0.0, 0.0};
  // On average, r is too small by (1 + 3 rho) / n.
  const double r = products / squares;
  constexpr double most_correlation = 0.9;
  const double rho = std::clamp(r + (1.0 + 3.0 * r) / count, 0.0, most_correlation);
  const double independent = std::max(2.0, count * (1.0 - rho) / (1.0 + rho));
  const double standard_error = std::sqrt(squares / ((count - 1.0) * independent));
  return {mean, standard_error, gsl_cdf_tdist_Pinv(0.975, independent - 1.0) * standard_error};
}

std::vector<ResultRow> collect(const std::filesystem::path& out, const Sweep& sweep,
                               std::span<const Task> tasks) {
  std::vector<ResultRow> rows;
  const std::size_t runs = runs_per_combination(sweep);
  for (std::size_t k = 0; k < tasks.size(); k += runs) {
    rows.push_back(collect_row(out, sweep, tasks.subspan(k, runs)));
  }
  return rows;
}

std::string to_csv(const Sweep& sweep, const std::vector<ResultRow>& rows) {
  std::string text;
  for (const std::string& name : sweep.columns) text += csv_cell(name) + ",";
  text += "runs,failed,unfinished";
  for (const Quantity& quantity : sweep.quantities) {
    for (const std::string& column : columns_of(quantity)) text += "," + column;
  }
  text += '\n';
  for (const ResultRow& row : rows) {
    for (const std::string& value : row.values) text += csv_cell(value) + ",";
    text += std::to_string(row.runs) + "," + std::to_string(row.failed) + "," +
            std::to_string(row.unfinished);
    for (const auto& [mean, standard_error, interval] : row.estimates) {
      for (const double number : {mean, standard_error, interval}) {
        text += ',' + exact_number(number);
      }
    }
    text += '\n';
  }
  return text;
}

std::string to_text(const Sweep& sweep, const std::vector<ResultRow>& rows) {
  std::vector<std::vector<std::string>> lines{sweep.columns};
  for (const char* count : {"runs", "failed", "unfinished"}) lines[0].emplace_back(count);
  for (const Quantity& quantity : sweep.quantities) lines[0].push_back(quantity.name);
  for (const ResultRow& row : rows) {
    std::vector<std::string>& line = lines.emplace_back(row.values);
    for (const int count : {row.runs, row.failed, row.unfinished}) {
      line.push_back(std::to_string(count));
    }
    for (const MeanEstimate& estimate : row.estimates) line.push_back(with_error_bar(estimate));
  }
  return aligned_rows(lines);
}

}  // namespace stokesbook
