#pragma once

#include <limits>
#include <optional>

#include "time_stepping/adams.hpp"
#include "time_stepping/step_control.hpp"
#include "time_stepping/stepping_method.hpp"

namespace stokesbook {

/// Parameters of a Stepper.
struct SteppingSettings {
  SteppingMethod method = SteppingMethod::euler;  ///< method that advances the state
  std::optional<double> dt{};  ///< longest step; embedded methods: first step, none: first_step()
  double dt_min = 0.0;         ///< least length with which a step that failed is repeated
  double dt_max = std::numeric_limits<double>::infinity();  ///< longest step of embedded methods
  ErrorBound bound{};  ///< bound of each step's estimated error, for embedded methods
};

/// Steps that are shorter than the settings say, because a longer one met an InadmissibleState.
struct ReducedSteps {
  double until = 0.0;     ///< time at which the step that met this state was to end
  double dt_after = 0.0;  ///< longest step after this time
};

/// Data of the previous steps. Together with time and state they determine all steps that follow.
struct StepMemory {
  std::optional<double> dt{};  ///< longest next step; none: that of the settings
  double error = 1.0;          ///< scaled error of the last step that was taken
  /// For methods of fixed steps, unless the rate has jumped.
  std::optional<PreviousStep> previous{};
  std::optional<ReducedSteps> reduced{};  ///< for methods of fixed steps, while steps are halved
};

/// The right-hand side, as a function for each kind of evaluation.
struct Rates {
  Rate within;  ///< for stages within a step and for trial steps
  Rate at_end;  ///< for the end of a step, at which the next step begins
};

/// Thrown when no step of at least the smallest allowed length has an error within the bound.
class StepError : public std::runtime_error {
 public:
  /// Stores the message.
  using std::runtime_error::runtime_error;
};

/// A step that was taken, with its estimated error, and the memory for the next step.
struct StepResult {
  Step step;                   ///< the next step begins at the end of this step
  Eigen::VectorXd error = {};  ///< estimated error of the step, n numbers
  StepMemory memory = {};      ///< memory for the next step
  int rejected = 0;            ///< number of longer steps that were tried and rejected
};

/// Divides the time from t to a later event into equal steps, none longer than `longest` > 0, and
/// returns the end of the first step: the event itself if one step is enough.
double choose_step_end(double t, double event, double longest);

/// Advances \f$ \dot q = f(t, q) \f$ step by step. A Stepper stores nothing between steps.
///
/// The lengths of steps before an event are made equal, so that the last step ends at the event
/// exactly. Embedded methods choose lengths by step_factor(), so that the scaled error of each step
/// is at most one. A step that meets an InadmissibleState is halved. Methods of fixed steps return
/// to their length at the time at which the step that was halved would have ended.
///
/// Each step has an estimate of its error that costs no evaluation of f. For embedded methods and
/// for Runge-Kutta 4 the estimate is the error of a lower order, and larger than the error of the
/// step, because the state advances by the weights of the higher order. For the methods of Euler,
/// Heun and Adams-Bashforth the estimate is adams_moulton_error(), which is close to the error of
/// the step.
/// @par Accuracy  orders of SteppingMethod, @ref claim_09_1 to @ref claim_09_7; errors of embedded
///                methods are proportional to the bound, @ref claim_09_17 to @ref claim_09_19
class Stepper {
 public:
  /// Stores settings and right-hand side.
  /// @param  settings  with a bound for embedded methods, and with dt for all others
  /// @param  rates     right-hand side; the same function twice if it does not distinguish the two
  Stepper(SteppingSettings settings, Rates rates)
      : settings_(std::move(settings)), rates_(std::move(rates)) {}

  /// Takes one step.
  ///
  /// @param  memory  that of the previous step; a new StepMemory for the first step
  /// @param  event   time > start.t that no step may pass; the step ends there if it is near enough
  /// @throws InadmissibleState when all steps down to dt_min meet such a state
  /// @throws StepError when all steps down to dt_min have errors above the bound
  /// @par Cost       for each step that is tried, one evaluation of f at the end and those of the
  ///                 stages; the cost of first_step() if no length of the first step is given
  StepResult advance(const TimePoint& start, StepMemory memory, double event) const;

 private:
  // Tries one step, without memory for the next step.
  StepResult attempt(const TimePoint& start, double t_end, const StepMemory& memory) const;
  double longest_step(const TimePoint& start, const StepMemory& memory) const;
  StepMemory update(StepMemory memory, const Step& step, double scaled_error, double longest,
                    bool rejected) const;

  SteppingSettings settings_;
  Rates rates_;
};

}  // namespace stokesbook
