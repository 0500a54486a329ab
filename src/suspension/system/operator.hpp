#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_correction.hpp"
#include "suspension/system/fast_sum.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The matrix-free operator of one configuration: density in, velocity at the nodes out.
///
/// \f$ (-\frac12 + D)(I-P)\eta \f$ as direct or fast sum, diagonal and near correction, plus what
/// closure and null-space fix add.
class SuspensionOperator {
 public:
  /// Plans sum, near correction and closure of one configuration.
  ///
  /// @param  problem  the boundary value problem, n nodes in all
  /// @param  placed   the same components for near corrections; empty: none
  /// @param  plan     how nodes are summed, and to what tolerance; that of the near corrections
  /// @throws std::invalid_argument when Closure refuses the problem
  SuspensionOperator(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                     const Plan& plan);

  /// Applies the operator.
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          velocities at all n nodes, length / time
  /// @par Cost        n^2 kernel evaluations, or O(n) by FastSum; and those of NearCorrection
  ComplexVector operator()(const ComplexVector& density) const;

  /// Assembles the right-hand side of the closure's system.
  /// @return velocities at all n nodes, length / time
  /// @par Cost  a singularity a node and loaded component, or O(n) by FastSum
  ComplexVector right_hand_side() const;

  /// Returns the position of each component's first node.
  /// @return one entry a component, and one more with the number of all nodes
  const std::vector<Eigen::Index>& offsets() const { return offsets_; }

  /// Returns the closure of the problem.
  /// @return what ties motions and loads to the density
  const Closure& closure() const { return closure_; }

 private:
  // The trapezoid rule's layer and the singularities of loads.
  ComplexVector plain_velocity(const ComplexVector& density, const std::vector<Load>& loads) const;

  std::vector<Curve> curves_;
  std::vector<Eigen::Index> offsets_;
  std::optional<std::size_t> enclosing_wall_;
  Closure closure_;
  std::variant<StressletSum, FastSum> sum_;
  std::optional<NearCorrection> near_;
};

/// @}

}  // namespace stokesbook
