#pragma once

#include <optional>
#include <string>

#include "suspension/motion/contact_stages.hpp"
#include "suspension/solver/solver.hpp"
#include "suspension/solver/tracers.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook {

/// Returns the settings with which a stepper advances the state of a scene.
///
/// The errors of positions are measured in units of the largest radius of a body, which is the
/// largest distance of its boundary from its position; the errors of orientations are measured in
/// radians. The results therefore do not depend on the units of length and time in a scene. A scene
/// without [time] has the defaults of TimeSettings.
/// @param  entries  number of entries of the state, which initial_state() makes
SteppingSettings stepping_settings(const SuspensionSolver& solver, Eigen::Index entries);

/// A step that is about to be taken.
struct StepStart {
  TimedSolution flow;  ///< flow at the beginning of the step, without contact forces
  double t_end;        ///< planned end
  std::optional<StageContact> contact{};  ///< contact at the beginning, in scenes with contact

  /// Returns what a frame shows: the solution with the contact forces, if there are any.
  const Solution& solution() const { return contact ? contact->solution : flow.solution; }
};

/// A step that was taken.
struct TakenStep {
  Step step;                           ///< from state to state
  StepMemory memory;                   ///< for the next step
  TimedSolution end;                   ///< the flow at the end
  std::optional<CloserGaps> closer{};  ///< pairs that are still closer than contact allows
  StepInfo info;                       ///< results and cost of the step
  Eigen::VectorXd error;               ///< estimated, of the state
  /// Tells, once in a run, what has cut steps to a tenth of time.dt or less; otherwise empty. There
  /// is no warning in runs with time.tolerance, since their steps have no given length.
  std::string warning{};
};

/// Takes the time steps of a scene: FreeSteps without contact, ContactSteps with contact.
class Steps {
 public:
  virtual ~Steps() = default;

  /// Finds the pairs that begin closer than contact allows, and their gaps; none in scenes without
  /// contact.
  ///
  /// @throws ConfigurationError as SuspensionContact::admit_start() does
  virtual std::optional<CloserGaps> admit_start(const TimePoint&) const { return {}; }

  /// Plans a step from a state with the given flow, which is without contact forces, and resolves
  /// the contact with which the step begins.
  ///
  /// @throws SolverError when contact of steps down to time.dt_min is not resolved
  virtual StepStart begin(const RunState& state, TimedSolution flow) = 0;

  /// Takes a step that begin() has planned from the same state.
  ///
  /// @throws SolverError when steps down to time.dt_min lead to inadmissible configurations, or
  ///                have errors that are not allowed
  /// @par Cost      a solve at the end, and one for each stage beyond the first
  virtual TakenStep advance(const RunState& state, StepStart start) = 0;
};

}  // namespace stokesbook
