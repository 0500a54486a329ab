#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// What an Fmm is planned with.
struct FmmSettings {
  int order = 0;               ///< p, highest power of the expansions, 1 to 60
  Eigen::Index leaf_size = 0;  ///< most points of a box that is not divided, >= 1

  /// Chooses order and leaf size for a tolerance.
  ///
  /// @param  tolerance  of velocities in the 2-norm over all targets, relative, > 0
  /// @return            settings
  /// @throws std::invalid_argument when the tolerance is not > 0
  static FmmSettings for_tolerance(double tolerance);
};

/// Returns the number of nodes above which an application of an Fmm takes less time than
/// StressletSum.
///
/// @param  settings  of the Fmm
/// @return           n
Eigen::Index break_even(const FmmSettings& settings);

/// @}

}  // namespace stokesbook
