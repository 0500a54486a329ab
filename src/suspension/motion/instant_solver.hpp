#pragma once

#include <functional>
#include <vector>

#include "suspension/motion/output_schedule.hpp"
#include "suspension/motion/run_state.hpp"
#include "suspension/motion/statistics.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Which error estimate a solution has.
enum class EstimateOf {
  earlier_solve,       ///< not its own: the latest one
  solution,            ///< its own
  solution_in_contact  ///< as earlier_solve, until the solution with its contact forces has one
};

/// A solution at a time of a run.
struct TimedSolution {
  Solution solution;                                ///< at that time
  SolveMemory before;                               ///< memory before the solve
  double seconds = 0.0;                             ///< wall time of the solve
  EstimateOf estimate = EstimateOf::earlier_solve;  ///< its error estimate
  int refinements = 0;  ///< how often contact required more nodes or a tighter GMRES tolerance
};

/// Computes a load on each body, about its position, in addition to those of the scene; loads on
/// held bodies have no effect.
///
/// The loads must depend on the arguments alone, because a step may be taken again. The motions of
/// all components are those of the solve before, without contact forces; there are none in the
/// first solve. Loads that depend on them lag by one stage, so that all steps have the order one.
using LoadFunction = std::function<std::vector<Load>(double t, const Configuration& configuration,
                                                     const std::vector<RigidMotion>& motions)>;

/// Solves the instants of a run one after the other. GMRES begins with densities extrapolated from
/// the solves before.
///
/// With the lagged coupling each solve is one sweep; a solve whose guess leaves a larger residual
/// than no guess is an error, since the sweeps diverge, as they do in crowds.
class InstantSolver {
 public:
  /// Starts without earlier solves. The first three arguments must outlive this.
  ///
  /// @param  loads  may be empty: no other loads than those of the scene
  InstantSolver(const SuspensionSolver& solver, const OutputSchedule& schedule,
                RunStatistics& statistics, LoadFunction loads);

  /// Solves an instant and remembers its densities. The error is estimated at written times, in the
  /// first solve, and after eight solves without an estimate; other solutions carry the latest
  /// estimate. Where contact has lasted, the estimate is left to ContactStages, which estimates the
  /// error of the solution with contact forces.
  ///
  /// @throws SolverError with the time, as SuspensionSolver::solve() does
  TimedSolution solve(const StepTime& time, const Configuration& configuration);

  /// Solves a stage within a step as solve() does, without an estimate of its error. The stage uses
  /// the tree of groups of the step's beginning if tree_lasts().
  ///
  /// The configuration of a stage deviates from the path of the bodies by dt^2, and so does its
  /// density. Where a stage and the end of its step have the same time, solve() remembers the
  /// deviation over dt^2, a smooth function of time. It is added to the guesses of later stages,
  /// and subtracted from the density of a stage for the guess at the end. The lagged coupling takes
  /// densities as they are.
  /// @param  tree  that of the solution with which the step begins; empty: none
  /// @par Accuracy  the guess at the end leaves a residual of order dt^4, @ref claim_09_40
  TimedSolution solve_stage(const StepTime& time, const Configuration& configuration,
                            const SharedTree& tree = {});

  /// Solves the instant of `flow` again with the node numbers that contact requires, and remembers
  /// its densities instead. The new solution has its own cost, and its own error estimate if `flow`
  /// has, else that of `flow`.
  ///
  /// @throws SolverError with the time, as SuspensionSolver::solve() does
  Solution solve_again(double t, const TimedSolution& flow);

  /// Accesses what the next solve takes from those before; contact extends it.
  SolveMemory& memory() { return memory_; }

 private:
  TimedSolution solve(const StepTime& time, const Configuration& configuration,
                      const DensityGuess& guess, EstimateOf estimate, const SharedTree& tree = {});
  Solution solve_from_guess(const Instant& instant, const DensityGuess& guess, EstimateOf estimate,
                            const SharedTree& tree) const;
  Solution solve_coupled(const Instant& instant, const DensityGuess& guess, EstimateOf estimate,
                         const SharedTree& tree = {}) const;
  Instant instant(const StepTime& time, const Configuration& configuration) const;
  DensityGuess density_guess(double t, const Configuration& configuration,
                             double deviations = 0.0) const;

  const SuspensionSolver& solver_;
  const OutputSchedule& schedule_;
  RunStatistics& statistics_;
  LoadFunction loads_;
  SolveMemory memory_;
};

}  // namespace stokesbook
