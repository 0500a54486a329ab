#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/estimate.hpp"
#include "sweep/sweep.hpp"

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// The results of all runs with one combination of the axes' values.
struct ResultRow {
  std::vector<std::string> values;  ///< one for each axis, in TOML's syntax
  int runs = 0;                     ///< number of runs that are done
  int failed = 0;                   ///< number of runs whose last attempt ended with an error
  int unfinished = 0;               ///< number of runs not begun, under way, or killed
  std::vector<Estimate> estimates;  ///< one for each quantity, from the runs that are done
};

/// Returns the names of the columns for a quantity.
///
/// @param  quantity  quantity of a sweep
/// @return           names for its mean, standard error and interval, see Estimate
std::array<std::string, 3> columns_of(const Quantity& quantity);

/// Collects the quantities of all runs that are done.
///
/// @param  out    folder of the sweep
/// @param  sweep  the sweep
/// @return        one row for each combination; the last axis varies fastest
/// @throws RecordError when the tables of a run that is done are damaged or end too early
std::vector<ResultRow> collect(const std::filesystem::path& out, const Sweep& sweep);

/// Writes results as `results.csv`.
///
/// @param  sweep  the sweep
/// @param  rows   its results
/// @return        text with the columns of the axes, `runs,failed,unfinished`, and columns_of()
///                each quantity, with 17 digits
std::string to_csv(const Sweep& sweep, const std::vector<ResultRow>& rows);

/// Writes results for the terminal: mean +- half the width of the 95 % confidence interval.
///
/// @param  sweep  the sweep
/// @param  rows   its results
/// @return        lines with aligned columns
std::string to_text(const Sweep& sweep, const std::vector<ResultRow>& rows);

/// @}

}  // namespace stokesbook
