#pragma once

#include <functional>
#include <optional>

#include "record/checkpoint.hpp"
#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/contact.hpp"
#include "suspension/density_history.hpp"
#include "suspension/rheology.hpp"
#include "suspension/stepping.hpp"

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
/// Reversals and the end are hit exactly. Methods that interpolate take their steps through written
/// times; all others even out their steps to hit them too. A step that leads into an
/// overlap, or too close for the nodes, is halved, see Stepper. The order in time.dt is that of the method.
///
/// With [contact], a step's velocity is that which keeps the separation at its end; it acts from the
/// step's beginning, and is what frames show. Steps that cannot be resolved are halved.
///
/// Solves begin with a guess from earlier ones, see DensityHistory. The error is estimated at
/// written times, and at the first step's end after eight solves without; steps between carry the
/// latest estimate.
/// @par Accuracy  of methods that adapt steps, time.tolerance within a factor of ten where the
///                motion is smooth and solver.tolerance is below it, @ref claim_09_18,
///                @ref claim_09_20; far better where the flow contracts, as onto a contact
/// @par Cost      one solve a step, and one for each stage beyond the first;
///                one at the start, after a reversal and at an interpolated written time;
///                evaluate_field() and Rheometer a written time
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
  double time() const { return now_.t; }

  /// Returns what the run has cost.
  /// @return counts since this simulation was made; steps since the start of the run
  const RunTotals& totals() const { return totals_; }

  /// Returns how finely the run was resolved, and how well.
  /// @return of this simulation's solves
  const RunResolution& resolution() const { return resolution_; }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  enum class Role { step, stage, frame };  // at a step's ends, within it, for a frame within it
  // What solves take from those before.
  struct SolveMemory {
    DensityHistory densities;
    double error_estimate = 0.0;  // the latest
    int since = 0;                // solves since then
  };
  struct Solved {
    Solution solution;
    SolveMemory before;
    double seconds = 0.0;
  };
  // The beginning of a step with contact: its end, and what holds where it begins.
  struct Begun {
    double t_end;
    ContactOutcome outcome;
    Solution solution;  // with the forces of contact
    SolveCost cost;     // of these
  };
  /// @endcond
  Solved solve(double t, const Eigen::VectorXd& state, Role role);
  Solution solve_by_guess(double t, const Configuration& configuration, bool estimated) const;
  Solved advance(const Solved& first);
  Begun begin_in_contact(const Solved& first, double t_end);
  Solved advance_in_contact(const Solved& first, Begun begun);
  ContactOutcome resolve(const ContactStage& stage, LoadResponse& response);
  ContactOutcome corrected(const Begun& begun, StepInfo& info);
  double planned_end() const;
  double halved(double t_end, const std::string& reason);
  Advance take_step(const Rates& rates) const;
  Solved reverse();
  void note_resolution(const Solution& solution);
  void adapt_to_effort(const StepInfo& step);
  void write_within(const Step& step);
  void write(double t, const Eigen::VectorXd& state, const Solution& solution,
             const std::vector<ContactForce>& contacts = {});
  Checkpoint checkpoint() const;
  bool is_reversal(double t) const;
  bool is_written_time(double t) const;
  double next_written_time(double t) const;
  double next_event() const;

  const SuspensionSolver& solver_;
  TimeSettings time_;
  SteppingSettings stepping_;
  Observer observer_;
  double drive_ = 1.0;
  Moment now_;  // the rate is set before a step
  StepMemory memory_;
  SolveMemory latest_;                        // after all solves but those for frames within steps
  SolveMemory begun_;                         // before the solve at now_
  double written_ = -1.0;                     // the last time on record
  std::optional<SuspensionContact> contact_;  // of scenes with [contact]
  CloserPairs closer_;                        // pairs that began closer than allowed
  std::optional<Rheometer> rheometer_;        // made for the first frame
  RunTotals totals_;
  RunResolution resolution_;
};

/// @}

}  // namespace stokesbook
