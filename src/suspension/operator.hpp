#pragma once

#include <optional>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_correction.hpp"
#include "suspension/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The matrix-free operator of one configuration: density in, velocity at the nodes out.
///
/// \f$ (-\frac12 + D)(I-P)\eta \f$ as sum, diagonal and near correction, plus what closure and
/// null-space fix add.
class SuspensionOperator {
 public:
  /// @param  problem  the boundary value problem
  /// @param  placed   the same components for near corrections; empty: none
  /// @param  plan     storage, tolerance and null-space fix
  SuspensionOperator(const StokesProblem& problem, const std::vector<PlacedCauchyCurve>& placed,
                     const Plan& plan);

  /// Applies the operator to a density at all nodes, length / time.
  ComplexVector operator()(const ComplexVector& density) const;

  /// Evaluates the fluid's velocity of a density, without the background.
  ///
  /// @param  density    at all nodes, length / time
  /// @param  points     in the fluid, length
  /// @param  placed     components for near corrections; empty: none
  /// @param  tolerance  of velocities relative to densities, for the near corrections
  /// @return            velocities, length / time
  ComplexVector velocity(const ComplexVector& density, const ComplexVector& points,
                         const std::vector<PlacedCauchyCurve>& placed, double tolerance) const;

  const Closure& closure() const { return closure_; }
  const std::optional<NearCorrection>& near_correction() const { return near_; }

 private:
  std::vector<Curve> curves_;
  std::vector<Eigen::Index> offsets_;
  std::optional<std::size_t> enclosing_wall_;
  Closure closure_;
  StressletSum sum_;
  std::optional<NearCorrection> near_;
};

/// @}

}  // namespace stokesbook
