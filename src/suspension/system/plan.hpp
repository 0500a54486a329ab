#pragma once

#include <optional>

#include <Eigen/Core>

#include "scene/scene.hpp"

namespace stokesbook {

/// The parts and tolerances of the solver that a scene requires, decided from the scene alone. The
/// solver builds nothing else. describe() explains the decisions.
struct Plan {
  bool null_space_fix = false;                                   ///< a wall encloses the fluid
  bool near_correction = false;                                  ///< components may come close
  PreconditionerKind preconditioner = PreconditionerKind::none;  ///< where gaps are wide and few
  bool direct_allowed = false;                                   ///< where direct_pays()
  bool tree_allowed = false;                                     ///< where tree_pays()
  double gmres_tolerance = 0.0;                                  ///< relative residual
  double near_tolerance = 0.0;  ///< tolerance of the near corrections, relative to the density
  double sum_tolerance = 0.0;   ///< tolerance of fast sums, relative in the 2-norm
  Summation summation = Summation::automatic;  ///< the choice of the scene

  /// Returns whether FastSum evaluates the flow of n nodes faster than the direct sum: at the nodes
  /// themselves if n is above break_even(), and at m targets, where every sum is planned anew, if
  /// m n / (m + n) is. The scene may select the sum instead. The answer is no if there are no
  /// targets, or if rounding errors of a fast sum exceed the tolerance.
  bool is_fast(Eigen::Index nodes, std::optional<Eigen::Index> targets = {}) const;
};

/// Decides which parts of the solver a scene requires.
Plan make_plan(const Scene& scene);

}  // namespace stokesbook
