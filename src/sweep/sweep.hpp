#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stokesbook {

/// A value of an axis.
struct AxisValue {
  std::string value;  ///< in TOML's syntax
  std::string where;  ///< place in the sweep file, "couette.toml:7:12"
};

/// An axis of a sweep: a key of the scene, or several that change together, and the values.
struct Axis {
  std::vector<std::string> keys;               ///< paths in the scene, "fill.0.area_fraction"
  std::vector<std::string> names;              ///< headers of the columns in tables, one a key
  std::vector<std::vector<AxisValue>> values;  ///< in order; each has one value for each key
};

/// Operation that reduces a column of a run's table, a function of time, to one number.
enum class Reduction {
  average,  ///< average over an interval of time
  last,     ///< value of the last row
  least,    ///< smallest value of all rows
  largest,  ///< largest value of all rows
  sum       ///< sum of all rows
};

/// A number that is collected from each run.
struct Quantity {
  std::string name;         ///< header of its columns in the results
  std::string table;        ///< table of the run, "rheology.csv"
  std::string column;       ///< column of the table
  std::optional<int> item;  ///< number of the body or wall, if the table has several
  Reduction reduction;      ///< operation on the column
  double from = 0.0;        ///< beginning of the average, time
  double to = 0.0;          ///< end of the average, time
  std::string where;        ///< place in the sweep file
  bool needs_cell = false;  ///< whether only scenes with a periodic cell have the column
};

/// A sweep: a scene, values for some of its keys, and quantities to collect from the runs.
struct Sweep {
  std::filesystem::path scene;         ///< scene file
  std::vector<Axis> axes;              ///< all combinations are run; the last axis varies fastest
  Axis seeds{{"seed"}, {"seed"}, {}};  ///< seeds of each combination; empty: the seed of the scene
  std::vector<std::string> columns;    ///< headers of the columns of all axes, without the seed
  std::vector<Quantity> quantities;    ///< quantities to collect
};

/// Returns the names of a quantity's columns in the results: mean, standard error and interval.
std::array<std::string, 3> columns_of(const Quantity& quantity);

/// Counts the runs for each combination of the axes' values, which differ only in their seeds.
std::size_t runs_per_combination(const Sweep& sweep);

/// Reads a sweep file and checks everything that can be checked without its scene.
///
/// The path of the scene in the file is relative to the folder of the file.
/// @throws SceneError at the first error, with its place, the wrong value and a right one
Sweep read_sweep(const std::filesystem::path& path);

}  // namespace stokesbook
