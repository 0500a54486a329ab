#pragma once

#include <limits>
#include <optional>

#include "time_stepping/adams_bashforth.hpp"
#include "time_stepping/step.hpp"
#include "time_stepping/step_control.hpp"
#include "time_stepping/stepping_method.hpp"

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// How a state is advanced.
struct SteppingSettings {
  SteppingMethod method = SteppingMethod::euler;  ///< that advances
  std::optional<double> dt{};  ///< longest step; of embedded methods the first, none: chosen
  double dt_min = 0.0;         ///< no step is made shorter than this to meet error or state
  double dt_max = std::numeric_limits<double>::infinity();  ///< of embedded methods: longest step
  ErrorBound bound{};  ///< of embedded methods: of each step's error as the method estimates it
};

/// Shorter steps around an InadmissibleState.
struct Detour {
  double end = 0.0;  ///< where the step that met it would have ended
  double dt = 0.0;   ///< longest step thereafter
};

/// What steps remember of those before; with time and state, all that the next ones depend on.
struct StepMemory {
  std::optional<double> dt{};  ///< longest next step; none: that of the settings
  double error = 1.0;          ///< scaled error of the last step that was taken
  std::optional<PreviousStep>
      previous{};                  ///< of methods of fixed steps, unless the rate has jumped
  std::optional<Detour> detour{};  ///< of methods of fixed steps, while steps are halved
};

/// The rate as a step asks for it.
struct Rates {
  Rate within;  ///< at stages within a step and in its trials
  Rate at_end;  ///< at the end of a step, where the next begins
};

/// No step that is long enough has an error that is allowed.
class StepRefused : public std::runtime_error {
 public:
  /// Takes the message.
  using std::runtime_error::runtime_error;
};

/// A step that was taken, and what it took.
struct Advance {
  Step step;              ///< whose end is where the next begins
  Eigen::VectorXd error;  ///< of the step as Stepper estimates it, n numbers
  StepMemory memory;      ///< for the next
  int rejected = 0;       ///< tries before that were longer
};

/// Returns the end of the first of equal steps to an event, none longer than a given one.
///
/// @param  t        start
/// @param  event    > t, time
/// @param  longest  step, > 0
/// @return          the event itself where one step is enough
double evened_end(double t, double event, double longest);

/// Advances \f$ \dot q = f(t, q) \f$ step by step; it keeps nothing between steps.
///
/// Steps are evened out to hit events exactly. Embedded methods choose them by step_factor(), so
/// that the scaled error of each is at most one. The state advances by the higher order of the
/// pair, while the estimate is that of the lower: per step, errors of the state are smaller than
/// the estimate by a power of h, so that those at a given time are in proportion to the tolerance.
/// A step that meets an InadmissibleState is halved; methods of fixed steps come back to theirs
/// where the step that was halved would have ended.
///
/// Each step has an estimate of its error, at no cost. Those of embedded methods, to which steps are
/// adapted, and of Runge-Kutta 4 are of the lower order, and larger than the error. For Euler's,
/// Heun's and Adams-Bashforth's method it is adams_moulton_error(), near the error itself; but of a
/// first step by Heun's method, with none before it, it shows one of two parts.
/// @par Accuracy  orders of SteppingMethod, @ref claim_09_1 to @ref claim_09_7; of embedded methods, errors
///                in proportion to the bound, @ref claim_09_17 to @ref claim_09_19
class Stepper {
 public:
  /// Takes the settings.
  ///
  /// @param  settings  with a bound for embedded methods and a step for all others
  /// @param  rates     right-hand side, twice the same where steps do not matter to it
  Stepper(SteppingSettings settings, Rates rates)
      : settings_(std::move(settings)), rates_(std::move(rates)) {}

  /// Takes one step.
  ///
  /// @param  start   with its rate
  /// @param  memory  of the step before, or none
  /// @param  event   time > start.t that no step may pass
  /// @return         the step, whose end is the event when it is near
  /// @throws InadmissibleState when steps down to dt_min meet one
  /// @throws StepRefused when steps down to dt_min have errors that are not allowed
  /// @par Cost       an evaluation of f at the end, and those of the stages; where there is no step
  ///                 to begin with, first_step()
  Advance advance(const TimePoint& start, StepMemory memory, double event) const;

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Try {
    Step step;
    Eigen::VectorXd error;
  };
  /// @endcond
  Try attempt(const TimePoint& start, double t_end, const StepMemory& memory) const;
  Try attempt_runge_kutta(const TimePoint& start, double t_end) const;
  double longest_step(const TimePoint& start, const StepMemory& memory) const;
  int power_of_estimate() const;  // the estimate of a step is of this order in h
  StepMemory after(const Try& tried, double scaled_error, double longest, bool rejected,
                   StepMemory memory) const;

  SteppingSettings settings_;
  Rates rates_;
};

/// @}

}  // namespace stokesbook
