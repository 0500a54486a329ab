#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// How the double layer's nodes are summed.
enum class SumMethod {
  stored,    ///< StressletSum with its kernel in a matrix
  streamed,  ///< StressletSum that evaluates its kernel anew
  fast       ///< FastSum
};

/// What a scene needs, decided from the scene alone; nothing that is not in the plan is built.
struct Plan {
  /// One decision with its reason, for the reader.
  struct Line {
    std::string topic,  ///< what is decided
        decision,       ///< how
        reason;         ///< why
  };

  bool null_space_fix = false;                                   ///< a wall encloses the fluid
  bool near_correction = false;                                  ///< components may come close
  PreconditionerKind preconditioner = PreconditionerKind::none;  ///< where gaps are wide
  bool direct_at_tight_gaps = false;           ///< factorise small systems where gaps are tight
  bool clusters_at_tight_gaps = false;         ///< precondition by clusters where gaps are tight
  double gmres_tolerance = 0.0;                ///< relative residual
  double near_tolerance = 0.0;                 ///< of the sums' quadrature, relative to the density
  double sum_tolerance = 0.0;                  ///< of fast sums, relative in the 2-norm
  Summation summation = Summation::automatic;  ///< as the scene asks
  std::vector<Line> lines;  ///< all decisions, in the order in which they are told

  /// Chooses how a number of nodes is summed: what is fastest, unless the scene asks otherwise.
  ///
  /// @param  nodes  in all
  /// @return        fast above break_even(), if the tolerance is not below what rounding allows
  SumMethod sum_method(Eigen::Index nodes) const;

  /// Chooses whether a flow is evaluated by FastSum, its plan included.
  ///
  /// @param  targets  m
  /// @param  nodes    n
  /// @return          true where m n / (m + n) is above break_even(), unless the scene asks
  ///                  otherwise
  bool is_fast_at(Eigen::Index targets, Eigen::Index nodes) const;

 private:
  bool is_fast(double pairs_a_point) const;
};

/// Decides what a scene needs.
///
/// @param  scene  to be solved
/// @return        what is to be built, and why
Plan make_plan(const Scene& scene);

/// @}

}  // namespace stokesbook
