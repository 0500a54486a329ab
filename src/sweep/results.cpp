// Collects quantities from the finished runs of a sweep, and writes their means and error bars.
#include "sweep/results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gsl/gsl_cdf.h>

#include "sweep/manifest.hpp"
#include "sweep/table_column.hpp"
#include "sweep/task.hpp"
#include "sweep/task_folder.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

ResultRow collect_row(const std::filesystem::path& out, const Sweep& sweep, std::size_t first) {
  ResultRow row;
  const Task task = task_of(sweep, first);
  for (std::size_t k = 0; k < sweep.axes.size(); ++k) {
    row.values.push_back(task.settings[k].chosen.value);
  }
  std::vector<std::vector<double>> values(sweep.quantities.size());
  for (std::size_t k = first; k < first + runs_per_combination(sweep); ++k) {
    const TaskFolder folder(out, k);
    const TaskState state = folder.state();
    if (state == TaskState::failed) ++row.failed;
    if (state == TaskState::unfinished) ++row.unfinished;
    if (state != TaskState::done) continue;
    ++row.runs;
    for (std::size_t j = 0; j < values.size(); ++j) {
      values[j].push_back(value_of(folder.path(), sweep.quantities[j]));
    }
  }
  for (const auto& of_quantity : values) row.estimates.push_back(estimate_mean(of_quantity));
  return row;
}

std::string with_error_bar(const MeanEstimate& estimate) {
  const std::string mean = short_number(estimate.mean, 6);
  return std::isnan(estimate.interval) ? mean : mean + " +- " + short_number(estimate.interval, 2);
}

}  // namespace

MeanEstimate estimate_mean(std::span<const double> values) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
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

std::array<std::string, 3> columns_of(const Quantity& quantity) {
  return {quantity.name, quantity.name + "_standard_error", quantity.name + "_interval"};
}

std::vector<ResultRow> collect(const std::filesystem::path& out, const Sweep& sweep) {
  std::vector<ResultRow> rows;
  for (std::size_t k = 0; k < task_count(sweep); k += runs_per_combination(sweep)) {
    rows.push_back(collect_row(out, sweep, k));
  }
  return rows;
}

std::string to_csv(const Sweep& sweep, const std::vector<ResultRow>& rows) {
  std::string text;
  for (const Axis& axis : sweep.axes) text += csv_cell(axis.name) + ",";
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
        text += ',';
        append_number(text, number);
      }
    }
    text += '\n';
  }
  return text;
}

std::string to_text(const Sweep& sweep, const std::vector<ResultRow>& rows) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Axis& axis : sweep.axes) lines[0].push_back(axis.name);
  for (const char* count : {"runs", "failed", "unfinished"}) lines[0].emplace_back(count);
  for (const Quantity& quantity : sweep.quantities) lines[0].push_back(quantity.name);
  for (const ResultRow& row : rows) {
    std::vector<std::string>& line = lines.emplace_back(row.values);
    for (const int count : {row.runs, row.failed, row.unfinished}) {
      line.push_back(std::to_string(count));
    }
    for (const MeanEstimate& estimate : row.estimates) line.push_back(with_error_bar(estimate));
  }
  std::vector<std::size_t> widths(lines[0].size());
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  }
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      text += std::string(2 + widths[k] - line[k].size(), ' ') + line[k];
    }
    text += '\n';
  }
  return text;
}

}  // namespace stokesbook
