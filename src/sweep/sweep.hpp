#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// One of the values that a key of the scene takes.
struct AxisValue {
  std::string value;  ///< in TOML's syntax
  std::string where;  ///< it stands in the sweep file, "couette.toml:7:12"
};

/// A key of the scene and the values that it takes.
struct Axis {
  std::string key;                ///< path in the scene, "fill.0.area_fraction"
  std::string name;               ///< heads the columns of tables
  std::vector<AxisValue> values;  ///< in order
};

/// What becomes of a column of a run's table, a function of time, to give one number.
enum class Reduction {
  average,  ///< over an interval of time
  last,     ///< value of the last row
  least,    ///< of all rows
  largest,  ///< of all rows
  sum       ///< of all rows
};

/// A number that each run gives.
struct Quantity {
  std::string name;         ///< heads its columns of the results
  std::string table;        ///< of the run, "rheology.csv"
  std::string column;       ///< of the table
  std::optional<int> item;  ///< number of the body or wall, where the table has several
  Reduction reduction;      ///< what is taken of the column
  double from = 0.0;        ///< begin of the average, time
  double to = 0.0;          ///< its end, time
  std::string where;        ///< it stands in the sweep file
};

/// A scene, values that some of its keys take, and what to collect of the runs.
struct Sweep {
  std::filesystem::path scene;       ///< scene file
  std::vector<Axis> axes;            ///< all combinations of their values are run, the last fastest
  Axis seeds{"seed", "seed", {}};    ///< each combination is run with each; empty: the scene's own
  std::vector<Quantity> quantities;  ///< of the results
};

/// @}

}  // namespace stokesbook
