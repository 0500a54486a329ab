#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// Parameters of an Fmm.
struct FmmSettings {
  int order = 0;               ///< p, highest power of the expansions, 1 to 60
  Eigen::Index leaf_size = 0;  ///< largest number of points of a leaf, >= 1

  /// Chooses order and leaf size for a tolerance \f$ \varepsilon \f$:
  /// \f$ p = \lceil 3.03\log_{10}(1/\varepsilon) - 0.6 \rceil \f$, leaves of at most 2 p + 32
  /// points.
  ///
  /// The relative error of one translation is at most about \f$ p\,2^{-p} \f$ (08.9). In a sum of
  /// many translations errors average out, and the total error falls like \f$ 10^{-p/3.03} \f$.
  /// This rule holds for all sets that were measured: random points, points on a line, clusters of
  /// points, crowding points, many ellipses and one slender ellipse, with smooth, wavy and random
  /// densities and up to 1e5 nodes. The slender ellipse meets the tolerance most narrowly. If most
  /// points are at one place then the errors add up, and p must satisfy
  /// \f$ p\,2^{-p} \le \varepsilon \f$.
  /// @param  tolerance  of velocities in the 2-norm over all targets, relative, > 0; below 1e-14,
  ///                    the size of rounding errors, the order stays that for 1e-14
  /// @par Accuracy      @ref claim_08_14 to @ref claim_08_16; one slender body @ref claim_08_23
  /// @throws std::invalid_argument when the tolerance is not > 0
  static FmmSettings for_tolerance(double tolerance);
};

/// Returns the number of nodes above which an application of an Fmm takes less time than
/// StressletSum: \f$ n = 300 + 18p \f$.
///
/// This straight line was fitted to times measured on ellipses of 16, 32 and 128 nodes, with one
/// thread and AVX-512. In these measurements an application takes as long as the direct sum for at
/// most n = 450, 600, 770 and 930 nodes, for 3, 6, 9 and 12 digits. With n nodes an Fmm takes about
/// half of the direct sum's operations, @ref claim_08_30.
Eigen::Index break_even(const FmmSettings& settings);

}  // namespace stokesbook
