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

/// What the runs of one combination of the axes' values say together.
struct ResultRow {
  std::vector<std::string> values;  ///< one an axis, in TOML's syntax
  int runs = 0;                     ///< that are done: these count
  int failed = 0;                   ///< whose last try ended with an error
  int unfinished = 0;               ///< not begun, under way, or killed
  std::vector<Estimate> estimates;  ///< one a quantity
};

/// Names the columns of a quantity.
///
/// @param  quantity  of a sweep
/// @return           those of its mean, standard error and interval, see Estimate
std::array<std::string, 3> columns_of(const Quantity& quantity);

/// Collects the quantities of all runs that are done.
///
/// @param  out    folder of the sweep
/// @param  sweep  the sweep
/// @return        one row a combination, the last axis fastest
/// @throws RecordError when the tables of a run that is done are damaged or end too early
std::vector<ResultRow> collect(const std::filesystem::path& out, const Sweep& sweep);

/// Writes results as `results.csv`.
///
/// @param  sweep  the sweep
/// @param  rows   its results
/// @return        the axes, `runs,failed,unfinished`, and for each quantity its columns_of(), with
///                17 digits
std::string to_csv(const Sweep& sweep, const std::vector<ResultRow>& rows);

/// Writes results for people: mean +- half the width of the 95 % confidence interval.
///
/// @param  sweep  the sweep
/// @param  rows   its results
/// @return        lines with aligned columns
std::string to_text(const Sweep& sweep, const std::vector<ResultRow>& rows);

/// @}

}  // namespace stokesbook
