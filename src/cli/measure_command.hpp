#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace stokesbook {

/// Options of `stokes measure`.
struct MeasureOptions {
  std::filesystem::path run;                            ///< folder of a run
  double from = 0.0;                                    ///< first time
  double to = std::numeric_limits<double>::infinity();  ///< last time
  std::vector<double> box = {};                         ///< empty: the region between the walls
  std::string across = "radius";                        ///< variable of the profiles
  double longest = 0.0;                                 ///< 0: eight mean radii
  int bins = 40;                                        ///< number of bins
  std::filesystem::path out = {};                       ///< empty: the folder of the run
};

/// Measures a run, writes tables and plots, and prints the means.
/// @throws SceneError, RecordError
int measure_run(const MeasureOptions& options);

}  // namespace stokesbook
