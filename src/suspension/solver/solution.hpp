#pragma once

#include <memory>
#include <vector>

#include "closure/closure.hpp"
#include "krylov/gmres.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/linear_system.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The work for a solution, including attempts with fewer nodes.
struct SolveCost {
  int gmres_iterations = 0;  ///< of all solves for motions and loads
  int matvecs = 0;           ///< applications of the operator, including those of error estimates
  /// Adds the work of another solve.
  /// @param  other  counts
  /// @return        the sum
  SolveCost& operator+=(const SolveCost& other) {
    gmres_iterations += other.gmres_iterations;
    matvecs += other.matvecs;
    return *this;
  }
};

/// One quasi-static solution: all that velocities, fields and rheology of its instant require.
struct Solution {
  Instant instant;                             ///< poses and flow amplitude
  Discretisation discretisation;               ///< nodes of the density
  std::shared_ptr<const LinearSystem> system;  ///< on these nodes; none if it was dropped
  ComplexVector density;                       ///< at all nodes, components in order, length / time
  std::vector<RigidMotion>
      motions;                  ///< of every component about its position: solved on free bodies,
                                ///< prescribed for held bodies and rigid walls, else zero
  std::vector<Load> loads;      ///< of every component on the fluid, about its position
  Complex uniform_velocity;     ///< of the fluid at infinity beside the background
  GmresResult gmres;            ///< of the linear system, converged
  double velocity_scale = 0.0;  ///< largest velocity in the data of the problem, which exclude the
                                ///< rigid motions of carried_by(); length / time
  double error_estimate = 0.0;  ///< of motions and loads, as relative_change() measures them; NaN
                                ///< if the error was not estimated
  std::vector<Gap> gaps;        ///< close pairs in ascending order, the closest pair first
  SolveCost cost;               ///< work for this solution
};

/// @}

}  // namespace stokesbook
