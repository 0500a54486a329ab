#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "suspension/motion/stepping.hpp"
#include "suspension/solver/rheology.hpp"

namespace stokesbook {

/// The receivers of what a run computes; every member may be empty.
struct Observer {
  std::function<void(const Frame&)> frame;            ///< called at every written time
  std::function<void(const StepInfo&)> step;          ///< called after every step
  std::function<void(const Checkpoint&)> checkpoint;  ///< called after every written frame
  std::function<void(const std::string&)> warning;    ///< called with each TakenStep::warning
};

/// Moves a scene from t = 0 to its end.
///
/// The end is hit exactly, and so are the times at which the forcing is not smooth, such as
/// reversals. Methods that interpolate step across written times; all other methods shorten their
/// steps evenly to hit them. The order of a method in time.dt is the one that chapter 09 gives.
/// FreeSteps takes the steps of scenes without contact, ContactSteps those of scenes with contact;
/// InstantSolver solves their stages.
/// @par Accuracy  of methods that adapt steps: time.tolerance within a factor of ten where the
///                motion is smooth and solver.tolerance is below it, @ref claim_09_18,
///                @ref claim_09_20; far better where the flow contracts, as onto a contact
/// @par Cost      one solve a step, and one for each stage beyond the first;
///                one at the start, after such a time and at an interpolated written time;
///                evaluate_field() and Rheometer a written time
class Simulation {
 public:
  /// Takes the configuration at the start of a scene with [time], or of any scene if only
  /// solve_once() is called. The solver must outlive the simulation.
  ///
  /// @param  loads  adds to the loads of the scene; may be empty
  /// @throws std::invalid_argument when the method is not embedded and time.dt is missing
  Simulation(const SuspensionSolver& solver, Observer observer, LoadFunction loads = {});

  Simulation(const Simulation&) = delete;  ///< forbidden: members refer to each other

  /// Continues from a checkpoint of the same scene: the run goes on bit for bit as if it had not
  /// stopped.
  ///
  /// @throws std::out_of_range when the checkpoint lacks something
  void resume(const Checkpoint& checkpoint);

  /// Continues from a checkpoint of a scene with the same bodies, walls and driving, and with other
  /// settings. Time, configuration and statistics are those of the checkpoint; steps, solves and
  /// contact begin anew.
  ///
  /// @throws std::out_of_range when the checkpoint lacks something
  /// @throws ConfigurationError when pairs are closer than the scene's contact allows
  void continue_from(const Checkpoint& checkpoint);

  /// Returns the checkpoint from which the run would continue now.
  Checkpoint checkpoint() const { return to_checkpoint(state_, statistics_); }

  /// Runs to the end.
  ///
  /// @throws SolverError with the time; what was written before stays
  void run();

  /// Writes the frame of the start and stops: one solve. The frame's contact is that of the first
  /// step, as ContactSteps::begin() plans it.
  ///
  /// @throws SolverError with the time
  void solve_once();

  double time() const { return state_.now.t; }  ///< returns the time reached

  /// Returns what the run has cost: counts of work since this simulation was made; all else since
  /// the start of the run.
  const RunTotals& totals() const { return statistics_.totals; }

  /// Returns how finely the run was resolved since its start, and how wrong it may be.
  const RunResolution& resolution() const { return statistics_.resolution; }

 private:
  TimedSolution solve_flow();
  TimedSolution accept(TakenStep taken);
  void restart();
  void adapt_to_effort(const StepInfo& step);
  void write(const StepStart& start);
  void write_within(const Step& step);
  void write(const TimePoint& point, const Solution& solution,
             const std::vector<ContactForce>& contacts);

  const SuspensionSolver& solver_;
  Observer observer_;
  OutputSchedule schedule_;
  RunStatistics statistics_;
  InstantSolver instants_;
  RunState state_;
  std::unique_ptr<Steps> steps_;
  std::optional<Rheometer> rheometer_;  // made for the first frame
};

}  // namespace stokesbook
