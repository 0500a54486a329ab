#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The ways in which the sum over all nodes of the double layer is computed.
enum class SumMethod {
  stored,    ///< StressletSum with its kernel in a matrix
  streamed,  ///< StressletSum that evaluates its kernel in every application
  fast       ///< FastSum
};

/// The parts and tolerances of the solver that a scene requires, decided from the scene alone. The
/// solver builds nothing else.
struct Plan {
  /// One decision with its reason, as text for the user.
  struct Line {
    std::string topic,  ///< subject of the decision
        decision,       ///< the decision
        reason;         ///< its reason
  };

  bool null_space_fix = false;                                   ///< a wall encloses the fluid
  bool near_correction = false;                                  ///< components may come close
  PreconditionerKind preconditioner = PreconditionerKind::none;  ///< if no gaps are tight
  bool direct_at_tight_gaps = false;           ///< factorise small systems where gaps are tight
  bool clusters_at_tight_gaps = false;         ///< precondition by clusters where gaps are tight
  double gmres_tolerance = 0.0;                ///< relative residual
  double near_tolerance = 0.0;                 ///< of the near corrections, relative to the density
  double sum_tolerance = 0.0;                  ///< of fast sums, relative in the 2-norm
  Summation summation = Summation::automatic;  ///< as the scene selects it
  std::vector<Line> lines;  ///< all decisions, in the order in which a run prints them

  /// Chooses the fastest sum for a number of nodes, unless the scene selects one.
  ///
  /// @param  nodes  number of all nodes
  /// @return        fast above break_even() nodes, unless rounding errors of a fast sum exceed the
  ///                tolerance; otherwise stored or streamed
  SumMethod sum_method(Eigen::Index nodes) const;

  /// Returns whether FastSum, with its planning, evaluates a flow faster than the direct sum.
  ///
  /// @param  targets  number of targets, m
  /// @param  nodes    number of all nodes, n
  /// @return          true if m n / (m + n) is above break_even(), unless the scene selects the
  ///                  sum; false without targets
  bool is_fast_at(Eigen::Index targets, Eigen::Index nodes) const;

 private:
  bool is_fast(double pairs_a_point) const;
};

/// Decides which parts of the solver a scene requires.
///
/// @param  scene  to be solved
/// @return        the decisions, with their reasons
Plan make_plan(const Scene& scene);

/// @}

}  // namespace stokesbook
