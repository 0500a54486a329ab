#pragma once

#include <array>
#include <functional>
#include <optional>

#include "record/checkpoint.hpp"
#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/motion/passing.hpp"
#include "suspension/motion/stepping.hpp"
#include "suspension/solver/density_history.hpp"
#include "suspension/solver/fields.hpp"
#include "suspension/solver/rheology.hpp"

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
/// overlap, or too close for the nodes, is halved, see Stepper. The order in
/// time.dt is that of the method.
///
/// With [contact], a step's velocity is that which keeps the separation at its end; it acts from
/// the step's beginning, and is what frames show. Steps that cannot be resolved are halved. With
/// time.tolerance, steps by Heun's method are adapted: the error of a step is the largest distance
/// of boundary points after its first half, by Euler's method, from where they are in the end, and
/// the next one is \f$ 0.9\,(tol/err)^{1/2} \f$ times as long, at least 0.3 and at most 1.5 times.
/// It is also no longer than lets bodies that come near each other move past each other by the
/// ratio of the smaller one's area and perimeter.
///
/// With the lagged coupling, a solve that begins with a residual above that of no density at all
/// is refused: the sweeps diverge, as they do in crowds.
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
  /// @throws std::out_of_range when it lacks what a run goes on from
  void resume(const Checkpoint& checkpoint);

  /// Runs to the end.
  ///
  /// @throws NumericsRefused with the time, when a configuration is refused; all earlier written
  ///                times stand
  void run();

  /// Writes the frame of the start and stops: one solve.
  ///
  /// Contact is that of the first step. Without [time] it is that of an instant in which the
  /// fastest boundary moves by a hundredth of the separation: forces keep those pairs apart whose
  /// gap is no wider than the separation already, but for that hundredth, and would close.
  /// @throws NumericsRefused with the time, when the configuration is refused
  void solve_once();

  /// Returns the time reached.
  /// @return t
  double time() const { return now_.t; }

  /// Returns what the run has cost.
  /// @return counts of work since this simulation was made; all else since the start of the run
  const RunTotals& totals() const { return totals_; }

  /// Returns how finely the run was resolved, and how well.
  /// @return of all solves since the start of the run
  const RunResolution& resolution() const { return resolution_; }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  enum class Role { step, stage, frame };  // at a step's ends, within it, for a frame within it
  // What solves take from those before.
  struct SolveMemory {
    DensityHistory densities;
    AnsweredLoads contacts{};                // of the stage before
    std::array<Eigen::VectorXd, 2> added{};  // by contact to velocities, in a step's stages
    Resolutions in_contact{};                // that its forces asked for
    int kept = 0;                            // steps with these
    double gmres_tolerance = 0.0;            // of these forces
    double error_estimate = 0.0;             // the latest
    int since = 0;                           // solves since then
  };
  struct Solved {
    Solution solution;
    SolveMemory before;
    double seconds = 0.0;
    bool estimated = false;
    int raised = 0;  // times that contact asked for more
  };
  // Where a stage of a step with contact begins and where its forces act: its mean velocity is the
  // share of the flow's there, beside what is known before.
  struct Stage {
    double t;  // where its forces act
    double dt;
    Configuration start, acting;
    double share;
    Eigen::VectorXd known;
    std::size_t index;    // in its step
    int most_iterations;  // of contact
  };
  // A stage, resolved or not.
  struct InContact {
    Solved free;
    ContactOutcome outcome;
    Solution solution;     // with the forces of contact
    SolveCost cost;        // of these, and of the flow on more nodes
    double seconds = 0.0;  // likewise
  };
  // The beginning of a step with contact: its end, and what holds where it begins. Costs are those
  // of longer steps, too.
  struct Begun {
    double t_end;
    InContact stage;
  };
  // The second half of a step by Heun's method.
  struct SecondHalf {
    ContactOutcome outcome;  // with the mean velocity of the step
    Eigen::VectorXd error;   // of the first half
    double error_in_bounds;  // the largest of a boundary point, over what is allowed
  };
  /// @endcond
  Solved solve(double t, const Eigen::VectorXd& state, Role role);
  DensityGuess guess(double t, const Configuration& configuration) const;
  Solution solve_by_guess(double t, const Instant& instant, bool estimated) const;
  Solved advance(const Solved& first);
  Begun begin_in_contact(Solved first, double t_end);
  Solved advance_in_contact(Begun begun);
  InContact in_contact(const Stage& stage, Solved free);
  LoadedCheck check(const InContact& found) const;
  void put_on_more_nodes(const Stage& stage, InContact& found);
  ContactOutcome resolve(const ContactStage& stage, LoadResponse& response);
  void ask_for_less(bool in_contact);
  SecondHalf second_half(const Begun& begun, StepInfo& info);
  double instant(const Solution& solution) const;
  double planned_dt() const;
  double planned_end() const;
  double end_within_scene(const Solution& solution, double t_end) const;
  double end_within_reach(const Configuration& configuration, const Eigen::VectorXd& free_velocity,
                          double t_end) const;
  double shortened(double t_end, double factor, const std::string& reason);
  void recover_length(double dt, bool shortened);
  void adapt_to_error(const StepInfo& step, double error, bool rejected);
  Advance take_step(const Rates& rates) const;
  Solved reverse();
  void note_solve(const Solution& solution);
  void note_response(const LoadResponse& response);
  void note_step(StepInfo step, const Eigen::VectorXd& error);
  void note_field(const EstimatedField& found);
  void note_resolution(const Solution& solution);
  void adapt_to_effort(const StepInfo& step);
  void write_within(const Step& step);
  void write(double t, const Solution& solution, const std::vector<ContactForce>& contacts = {});
  Checkpoint checkpoint() const;
  bool is_reversal(double t) const;
  bool is_written_time(double t) const;
  double rounding_of_written_times() const;
  double next_written_time(double t) const;
  double next_event() const;

  const SuspensionSolver& solver_;
  TimeSettings time_;
  SteppingSettings stepping_;
  Observer observer_;
  double amplitude_ = 1.0;  // of the flow: 1, or -1 after an odd number of reversals
  TimePoint now_;           // the rate is set before a step
  StepMemory memory_;
  SolveMemory latest_;                        // after all solves but those for frames within steps
  SolveMemory begun_;                         // before the solve at now_
  double written_ = -1.0;                     // the last time on record
  std::optional<SuspensionContact> contact_;  // of scenes with [contact]
  std::optional<PassingTest> passing_;        // of others
  CloserPairs closer_;                        // pairs that began closer than allowed
  std::optional<Rheometer> rheometer_;        // made for the first frame
  RunTotals totals_;
  RunResolution resolution_;
  Eigen::VectorXd errors_;  // of all steps, added up
};

/// @}

}  // namespace stokesbook
