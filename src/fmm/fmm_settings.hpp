#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// What an Fmm is planned with.
struct FmmSettings {
  int order = 0;               ///< p, highest power of the expansions, 1 to 60
  Eigen::Index leaf_size = 0;  ///< most points of a box that is not divided, >= 1

  /// Chooses order and leaf size for a tolerance \f$ \varepsilon \f$:
  /// \f$ p = \lceil 3.03\log_{10}(1/\varepsilon) - 0.6 \rceil \f$, leaves of 2 p + 32 points.
  ///
  /// One translation leaves out \f$ p\,2^{-p} \f$ of a velocity at worst, a sum of many much less;
  /// what all leave out falls like \f$ 10^{-p/3.03} \f$. The constant holds for what was measured:
  /// random points, points on a line, in clusters, crowding; many ellipses and one slender one, at
  /// which it is met most narrowly; densities smooth, wavy and random; up to 1e5 nodes.
  /// Not for most points at one place, where errors add: \f$ p\,2^{-p} \le \varepsilon \f$ there.
  /// @param  tolerance  of velocities in the 2-norm over all targets, relative, > 0; below 1e-14,
  ///                    which rounding leaves, the order does not grow any more
  /// @return            settings
  /// @par Accuracy      @ref claim_08_14 to @ref claim_08_16; one slender body @ref claim_08_23
  /// @throws std::invalid_argument when the tolerance is not > 0
  static FmmSettings for_tolerance(double tolerance);
};

/// Returns the number of nodes above which an application of an Fmm takes less time than
/// StressletSum: \f$ n = 300 + 18p \f$.
///
/// Measured on ellipses of 16, 32 and 128 nodes with one thread and AVX-512: where an application
/// takes as long as the direct sum, n = 450, 600, 770, 930 for 3, 6, 9 and 12 digits at the latest.
/// @param  settings  of the Fmm
/// @return           n; about half of the direct sum's operations are left there, @ref claim_08_30
Eigen::Index break_even(const FmmSettings& settings);

/// @}

}  // namespace stokesbook
