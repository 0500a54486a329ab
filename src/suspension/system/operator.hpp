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

/// The matrix-free operator (12.1) of one configuration: maps a density to velocities at the nodes.
///
/// The layer \f$ (-\frac12 + D)(I-P)\eta \f$ is a direct or fast sum with diagonal and near
/// correction. The closure and the null-space fix add their terms.
class SuspensionOperator {
 public:
  /// Plans sum, near correction and closure of one configuration.
  ///
  /// @param  problem  the boundary value problem, n nodes in all
  /// @param  placed   placed curves of the components for near corrections; empty: none
  /// @param  plan     method and tolerance of the sums, and tolerance of the near corrections
  /// @throws std::invalid_argument when Closure refuses the problem
  SuspensionOperator(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                     const Plan& plan);

  /// Applies the operator.
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          velocities at all n nodes, length / time
  /// @par Cost        n^2 kernel evaluations, or O(n) by FastSum; and that of NearCorrection
  ComplexVector operator()(const ComplexVector& density) const;

  /// Assembles the right-hand side of the closure's system.
  /// @return velocities at all n nodes, length / time
  /// @par Cost  a Stokeslet and a rotlet per node and loaded component, or O(n) by FastSum
  ComplexVector right_hand_side() const;

  /// Returns the position of each component's first node.
  /// @return one entry per component, and one more with the number of all nodes
  const std::vector<Eigen::Index>& offsets() const { return offsets_; }

  /// Returns the closure of the problem.
  /// @return closure, which computes motions and loads from the density
  const Closure& closure() const { return closure_; }

 private:
  // Evaluates the double layer by the trapezoid rule, and the singularities of loads.
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
