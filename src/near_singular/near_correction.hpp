#pragma once

#include <vector>

#include "near_singular/near_targets.hpp"

namespace stokesbook {

/// Data that a near correction stores between applications.
enum class NearStorage {
  automatic,     ///< for each curve the cheaper of the two in about thirty applications
  factored,      ///< no data: every application evaluates the scheme
  explicit_rows  ///< the matrix from a curve's density to its targets, 32 N bytes per target
};

/// Parameters of a near correction.
struct NearSettings {
  double tolerance = 1e-14;  ///< tolerance of velocities relative to densities, > 0
  NearStorage storage = NearStorage::automatic;  ///< data that are stored
};

/// Corrects a trapezoid sum at the targets for which the rule is too coarse: replaces the rule of
/// each near curve by a scheme of close evaluation (06.17). A correction is planned once per
/// geometry and applied many times.
///
/// @par Accuracy  that of the scheme, at any gap, once the density is resolved: @ref claim_06_30,
/// @ref claim_06_31; never worse than the sum without correction: @ref claim_06_33
/// @par Cost      factored, by the Cauchy scheme: 12 N^2 real multiplications per curve with near
/// targets and 50 N operations per near target, O(1) memory per pair; explicit rows: 4 N real
/// multiplications per near target, 24 N^2 once
class NearCorrection {
 public:
  /// Finds the near targets of every curve, and assembles the rows of the curves that store them.
  ///
  /// @param  curves   in the order of the densities
  /// @param  targets  m points, length
  /// @param  images   vectors by which images of all curves, with the same densities, are moved
  /// @par Cost        that of find_near_targets(), and of the rows
  NearCorrection(std::vector<PlacedCurve> curves, const ComplexVector& targets, Targets kind,
                 const NearSettings& settings, const std::vector<Complex>& images = {});

  /// Evaluates scheme minus trapezoid rule, summed over the near curves of each target (06.17).
  ///
  /// @param  density  at all nodes, in the curves' order, length / time
  /// @return          velocities at the m targets, length / time
  ComplexVector operator()(const ComplexVector& density) const;

  /// Counts the pairs of a target and a curve that is near it.
  Eigen::Index pair_count() const;

  /// Counts the curves whose rows are stored.
  Eigen::Index explicit_count() const { return static_cast<Eigen::Index>(rows_.size()); }

 private:
  struct Rows {
    std::size_t curve;
    Eigen::MatrixXd matrix;  // density -> scheme minus trapezoid rule, interleaved, curve's frame
  };
  struct Group {
    std::vector<std::size_t> curves;  // curves that share a scheme
    StressletSum trapezoid;
  };
  ComplexVector local_density(const ComplexVector& density, std::size_t curve) const;
  void evaluate(const Group& group, const ComplexVector& density,
                std::vector<ComplexVector>& corrections) const;

  std::vector<PlacedCurve> curves_;
  std::vector<Eigen::Index> offsets_;  // first node of each curve, and the total
  std::vector<NearTargets> near_;      // near targets of each curve
  std::vector<Rows> rows_;             // rows of the curves with explicit rows
  std::vector<Group> groups_;          // groups of the other curves with near targets
  Eigen::Index target_count_;
};

/// Evaluates the corrections that make StressletSum::derivatives() accurate at any distance from
/// the curves, 1 / time: Cauchy scheme minus trapezoid rule. On a node of a curve the corrected
/// values are the limits from the fluid.
///
/// @param  curves     placed curves, in the order of the densities, with the Cauchy scheme
/// @param  density    at all nodes, in the curves' order, length / time
/// @param  tolerance  relative to the densities' derivatives, > 0; decides which targets are near
/// @param  images     vectors by which images of all curves are moved, length
/// @return            one per target, zero at targets that are not near
/// @throws std::invalid_argument when a curve has another scheme
/// @par Accuracy  1e-11 relative, once the densities are resolved: @ref claim_06_8
/// @par Cost      O(N^2) per curve with near targets, 50 N operations per near target
std::vector<FlowDerivatives> near_derivative_corrections(const std::vector<PlacedCurve>& curves,
                                                         const ComplexVector& density,
                                                         const ComplexVector& targets,
                                                         double tolerance,
                                                         const std::vector<Complex>& images = {});

}  // namespace stokesbook
