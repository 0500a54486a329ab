#pragma once

#include <functional>
#include <optional>

#include "record/checkpoint.hpp"
#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/rheology.hpp"
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
/// Steps are no longer than time.dt, evened out so that written times, reversals and the end are
/// hit exactly. Where there is no earlier rate, at the start and after a reversal,
/// Adams-Bashforth 2 takes a step by Runge-Kutta 4. The order in time.dt is that of the method.
/// @par Cost      one solve a step with its error estimate, three more solves by Runge-Kutta 4, and
/// one at the end; evaluate_field() and Rheometer a written time
class Simulation {
 public:
  /// Takes the scene's initial configuration.
  ///
  /// @param  solver    of a scene with [time], unless only solve_once() is called; must outlive the
  ///                   simulation
  /// @param  observer  who is told what
  Simulation(const SuspensionSolver& solver, Observer observer);

  /// Goes on from a checkpoint: the run continues bit for bit as if it had not stopped.
  ///
  /// @param  checkpoint  of a run of the same scene
  void resume(const Checkpoint& checkpoint);

  /// Runs to the end.
  ///
  /// @throws NumericsRefused with the time, when a configuration is refused; all earlier written
  ///                times stand
  void run();

  /// Writes the frame of the start and stops: one solve.
  ///
  /// @throws NumericsRefused with the time, when the configuration is refused
  void solve_once();

  /// Returns the time reached.
  /// @return t
  double time() const { return t_; }

  /// Returns what the run has cost.
  /// @return counts since this simulation was made; steps since the start of the run
  const RunTotals& totals() const { return totals_; }

  /// Returns how finely the run was resolved, and how well.
  /// @return of this simulation's solves; inner stages of steps left out
  const RunResolution& resolution() const { return resolution_; }

 private:
  // Inner stages of a step give the step's first solution.
  Solution solve(const Eigen::VectorXd& state, const Solution* first_of_step = nullptr);
  void note_resolution(const Solution& solution);
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
  std::optional<Rheometer> rheometer_;  // made for the first frame
  StepInfo step_;                       // of the step under way
  RunTotals totals_;
  RunResolution resolution_;
  bool written_ = false;  // the frame of t_ is on record
};

/// Packs placements into a state.
///
/// @param  configuration  K components
/// @return                3K numbers: x, y, orientation of every component
Eigen::VectorXd to_state(const Configuration& configuration);

/// Unpacks a state.
///
/// @param  state  3K numbers, as to_state() packs them
/// @return        placements of K components
Configuration to_configuration(const Eigen::VectorXd& state);

/// @}

}  // namespace stokesbook
