#pragma once

#include <functional>
#include <optional>

#include "record/checkpoint.hpp"
#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/solver.hpp"
#include "time_stepping/steps.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Who is told what during a run; every member may be empty.
struct Observer {
  std::function<void(const Frame&)> frame;            ///< at every written time
  std::function<void(const StepInfo&)> step;          ///< after every step
  std::function<void(const Checkpoint&)> checkpoint;  ///< after every written frame
};

/// Moves a scene from t = 0 to its end.
///
/// Steps are as long as time.dt, evened out so that written times, reversals and the end are hit
/// exactly.
class Simulation {
 public:
  /// @param  solver    of a scene with [time]; must outlive the simulation
  /// @param  observer  what is told of the run
  Simulation(const SuspensionSolver& solver, Observer observer);

  /// Goes back to a checkpoint; the run then continues bit for bit as if it had not stopped.
  void resume(const Checkpoint& checkpoint);

  /// Runs to the end.
  ///
  /// @throws NumericsRefused  with the time, when a configuration is refused; all earlier written
  /// times stand
  void run();

  /// Writes the frame of the start and stops: one solve.
  void solve_once();

  double time() const { return t_; }
  const RunTotals& totals() const { return totals_; }

 private:
  Solution solve(const Eigen::VectorXd& state);
  void advance(const Solution& now);
  void write(const Solution& now);
  Checkpoint checkpoint() const;
  double next_event() const;
  bool is_written_time() const;

  const SuspensionSolver& solver_;
  TimeSettings time_;
  Observer observer_;
  double t_ = 0.0;
  double drive_ = 1.0;
  Eigen::VectorXd state_;
  std::optional<PreviousStep> previous_;
  StepInfo step_;  // of the step under way
  RunTotals totals_;
  bool written_ = false;  // the frame of t_ is on record
};

/// Packs placements into a state (x, y, orientation of every component).
Eigen::VectorXd to_state(const Configuration& configuration);

/// Unpacks a state.
Configuration to_configuration(const Eigen::VectorXd& state);

/// @}

}  // namespace stokesbook
