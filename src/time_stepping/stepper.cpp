// Takes one step by any of the methods. A step that fails, because of its error or because of an
// inadmissible state, is repeated with a shorter length (chapter 09).
#include "time_stepping/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "time_stepping/runge_kutta.hpp"

namespace stokesbook {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

const Tableau& tableau_of(SteppingMethod method) {
  switch (method) {
    case SteppingMethod::euler:
      return euler();
    case SteppingMethod::rk4:
      return runge_kutta4();
    case SteppingMethod::bogacki_shampine32:
      return bogacki_shampine32();
    case SteppingMethod::dormand_prince54:
      return dormand_prince54();
    default:  // Adams-Bashforth begins with Heun's scheme; Prince and Dormand's pair needs none
      return heun();
  }
}

StepError too_short(double dt, double error) {
  std::ostringstream message;
  message << "the estimated error of a step of " << dt << " is " << error
          << " times what is allowed";
  return StepError(message.str());
}

}  // namespace

double choose_step_end(double t, double event, double longest) {
  // A remainder below 1e-9 of a step is rounding, and needs no further step.
  const double steps = std::ceil((event - t) / longest - 1e-9);
  return steps > 1.0 ? t + (event - t) / steps : event;
}

// The end by (09.5), (09.6) or GSL, and an estimate that includes the rate at the end: of the form
// (09.7), or (09.8) if the method has no estimate of its own.
StepResult Stepper::attempt(const TimePoint& start, double t_end, const StepMemory& memory) const {
  const double dt = t_end - start.t;
  const Tableau& tableau = tableau_of(settings_.method);
  StepResult result{{start, {t_end, {}, {}}}};
  TimePoint& end = result.step.end;
  MatrixXd stages;
  if (settings_.method == SteppingMethod::prince_dormand87) {
    EstimatedEnd estimated = prince_dormand87_step(rates_.within, start, dt);
    end.state = std::move(estimated.end);
    result.error = std::move(estimated.error);
  } else if (settings_.method == SteppingMethod::adams_bashforth2 && memory.previous) {
    end.state = adams_bashforth2_step(start, dt, *memory.previous);
  } else {
    stages = runge_kutta_stages(tableau, rates_.within, start, dt);
    end.state = start.state + dt * (stages * tableau.b);
  }
  end.rate = rates_.at_end(t_end, end.state);
  const auto combined = [&](const VectorXd& weights) -> VectorXd {
    return stages * weights.head(stages.cols()) + weights[stages.cols()] * end.rate;
  };
  if (tableau.error.size() > 0) result.error = dt * combined(tableau.error);
  if (tableau.bubble.size() > 0) result.step.bubble = combined(tableau.bubble);
  if (result.error.size() == 0) result.error = adams_moulton_error(result.step, memory.previous);
  return result;
}

double Stepper::longest_step(const TimePoint& start, const StepMemory& memory) const {
  if (memory.dt) return *memory.dt;
  if (settings_.dt) return *settings_.dt;
  return first_step(rates_.within, start, settings_.bound, order_of(settings_.method));
}

StepMemory Stepper::update(StepMemory memory, const Step& step, double scaled_error, double longest,
                           bool rejected) const {
  const double dt = step.dt();
  if (is_embedded(settings_.method)) {
    // The error of a step that an event has cut short is no basis for the length of longer steps.
    const bool cut = dt < 0.5 * longest;
    const double factor = step_factor(scaled_error, memory.error, order_of(settings_.method));
    memory.dt = cut ? longest : dt * (rejected ? std::min(factor, 1.0) : factor);
    if (!cut) memory.error = scaled_error;
    return memory;
  }
  if (memory.reduced) {
    const bool over = step.end.t >= memory.reduced->until;
    memory.dt = over ? memory.reduced->dt_after : longest;
    if (over) memory.reduced.reset();
  }
  memory.previous = PreviousStep{dt, step.start.rate};
  return memory;
}

StepResult Stepper::advance(const TimePoint& start, StepMemory memory, double event) const {
  double longest = std::min(longest_step(start, memory), settings_.dt_max);
  for (int rejected = 0;; ++rejected) {
    const double stop = memory.reduced ? std::min(event, memory.reduced->until) : event;
    const double t_end = choose_step_end(start.t, stop, longest);
    const double dt = t_end - start.t;
    try {
      StepResult result = attempt(start, t_end, memory);
      const double error = is_embedded(settings_.method) ? settings_.bound(result.error) : 0.0;
      if (error <= 1.0) {
        result.memory = update(std::move(memory), result.step, error, longest, rejected > 0);
        result.rejected = rejected;
        return result;
      }
      longest = dt * step_factor(error, memory.error, order_of(settings_.method));
      if (longest < settings_.dt_min) throw too_short(dt, error);
    } catch (const InadmissibleState&) {
      if (!is_embedded(settings_.method) && !memory.reduced) {
        memory.reduced = ReducedSteps{t_end, longest};
      }
      longest = 0.5 * dt;
      if (longest < settings_.dt_min) throw;
    }
  }
}

}  // namespace stokesbook
