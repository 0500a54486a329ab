#pragma once

#include "suspension/motion/run_state.hpp"
#include "suspension/motion/statistics.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// A solution at a time of a run.
struct TimedSolution {
  Solution solution;       ///< at that time
  SolveMemory before;      ///< memory before the solve
  double seconds = 0.0;    ///< wall time of the solve
  bool estimated = false;  ///< whether the error estimate is its own, not that of an earlier solve
  int raised = 0;          ///< how often contact required more nodes or a tighter GMRES tolerance
};

/// When a solve estimates its error.
enum class EstimateWhen {
  always,    ///< in this solve
  when_due,  ///< where several solves before did not
  never      ///< not in this solve
};

/// Solves the instants of a run one after the other. GMRES begins with densities extrapolated from
/// the solves before.
///
/// With the lagged coupling each solve is one sweep; a solve whose guess leaves a larger residual
/// than no guess is an error, since the sweeps diverge, as they do in crowds.
class InstantSolver {
 public:
  /// Starts without earlier solves.
  ///
  /// @param  solver      of the scene, which must outlive this
  /// @param  statistics  that count the solves, which must outlive this
  InstantSolver(const SuspensionSolver& solver, RunStatistics& statistics);

  /// Solves an instant and remembers its densities.
  ///
  /// @param  t         time
  /// @param  instant   then
  /// @param  estimate  when the error is estimated; other solutions carry the latest estimate
  /// @return           the solution and its cost
  /// @throws SolverError with the time, as SuspensionSolver::solve() does
  TimedSolution solve(double t, const Instant& instant, EstimateWhen estimate);

  /// Solves the same instant again with the node numbers that contact requires, and remembers its
  /// densities instead.
  ///
  /// @param  t     time
  /// @param  flow  solution on fewer nodes, without contact forces
  /// @return       the new solution with the error estimate of `flow`; its cost is its own
  /// @throws SolverError with the time, as SuspensionSolver::solve_nearby() does
  Solution solve_again(double t, const Solution& flow);

  /// Accesses what the next solve takes from those before.
  /// @return the memory, which contact extends
  SolveMemory& memory() { return memory_; }

 private:
  DensityGuess guess(double t, const Configuration& configuration) const;
  Solution solve_by_guess(double t, const Instant& instant, bool estimated) const;

  const SuspensionSolver& solver_;
  RunStatistics& statistics_;
  SolveMemory memory_;
};

/// @}

}  // namespace stokesbook
