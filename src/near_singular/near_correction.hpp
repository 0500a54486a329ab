#pragma once

#include <vector>

#include "near_singular/near_targets.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// What a near correction keeps between applications.
enum class NearStorage {
  automatic,     ///< the cheaper one for about thirty applications, a curve at a time
  factored,      ///< nothing: every application evaluates the scheme
  explicit_rows  ///< the map from a curve's density to its targets, 32 N bytes a target
};

/// How a near correction is to be planned.
struct NearSettings {
  double tolerance = 1e-14;                      ///< of velocities relative to densities, > 0
  NearStorage storage = NearStorage::automatic;  ///< what is kept
};

/// The near correction of a trapezoid sum: replaces it by a scheme of close evaluation at the
/// targets where the rule is too coarse. Planned once per geometry, applied many times.
///
/// @par Accuracy  that of the scheme, at any gap, once the density is resolved: @ref claim_06_30,
/// @ref claim_06_31; never worse than without: @ref claim_06_33
/// @par Cost      factored, by the Cauchy scheme: 12 N^2 real multiplications a curve with near
/// targets and 50 N operations a near target, O(1) memory a pair; explicit rows: 4 N real
/// multiplications a near target, 24 N^2 once
class NearCorrection {
 public:
  /// Finds the near targets of every curve and assembles the rows that pay.
  ///
  /// @param  curves    placed curves, in the order of the densities
  /// @param  targets   m points, length
  /// @param  kind      what the targets are
  /// @param  settings  tolerance, which decides what is near, and storage
  /// @par Cost         that of find_near_targets(), and of the rows
  NearCorrection(std::vector<PlacedCurve> curves, const ComplexVector& targets, Targets kind,
                 const NearSettings& settings);

  /// Evaluates scheme minus trapezoid rule, summed over the near curves of each target.
  ///
  /// @param  density  at all nodes, in the curves' order, length / time
  /// @return          velocities at the m targets, length / time
  ComplexVector operator()(const ComplexVector& density) const;

  /// Counts the pairs of a target and a curve that is near it.
  /// @return number of corrections that are summed
  Eigen::Index pair_count() const;

  /// Counts the curves whose rows are kept.
  /// @return 0 for factored storage
  Eigen::Index explicit_count() const { return static_cast<Eigen::Index>(rows_.size()); }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Rows {
    std::size_t curve;
    Eigen::MatrixXd matrix;  // density -> scheme minus trapezoid rule, interleaved, curve's frame
  };
  struct Group {
    std::vector<std::size_t> curves;  // that share a scheme
    StressletSum trapezoid;
  };
  /// @endcond
  ComplexVector local_density(const ComplexVector& density, std::size_t curve) const;
  void evaluate(const Group& group, const ComplexVector& density,
                std::vector<ComplexVector>& corrections) const;

  std::vector<PlacedCurve> curves_;
  std::vector<Eigen::Index> offsets_;  // first node of each curve, and the total
  std::vector<NearTargets> near_;      // of each curve
  std::vector<Rows> rows_;             // of curves for which they pay
  std::vector<Group> groups_;          // of the other curves with near targets
  Eigen::Index target_count_;
};

/// @}

}  // namespace stokesbook
