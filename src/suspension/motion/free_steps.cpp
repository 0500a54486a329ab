// Takes steps without contact: the rates of chapter 09's stepper are solutions of instants.
#include "suspension/motion/free_steps.hpp"

#include <optional>
#include <utility>

#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/statistics.hpp"
#include "suspension/motion/stepping.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// Marks the states from which a stepper takes a shorter step.
Rate shorter_on_error(const Rate& rate) {
  return [=](double t, const VectorXd& state) {
    try {
      return rate(t, state);
    } catch (const ConfigurationError& error) {
      throw InadmissibleState(error.what());
    }
  };
}

}  // namespace

FreeSteps::FreeSteps(const SuspensionSolver& solver, const OutputSchedule& schedule,
                     InstantSolver& instants, RunStatistics& statistics)
    : schedule_(schedule),
      instants_(instants),
      statistics_(statistics),
      settings_(stepping_settings(solver)),
      passing_(solver) {}

StepStart FreeSteps::begin(const RunState& state, TimedSolution flow) {
  return {std::move(flow), schedule_.next_event(state.now.t)};
}

TakenStep FreeSteps::advance(const RunState& state, StepStart start) {
  const TimedSolution& first = start.flow;
  const Configuration here = to_configuration(state.now.state);
  StepInfo info = begin_step(first.solution, first.seconds);
  const double closest = info.min_gap;
  std::optional<TimedSolution> last;
  const auto within = [&](double t, const VectorXd& q) {
    const TimedSolution stage = instants_.solve_stage(t, {to_configuration(q), state.amplitude});
    info = with_solve(info, stage.solution, stage.seconds);
    return to_rate(stage.solution);
  };
  const auto at_end = [&](double t, const VectorXd& q) {
    if (last) info = with_solve(info, last->solution, last->seconds);  // of a rejected step
    const Configuration there = to_configuration(q);
    const std::string passing = passing_.error(here, there, closest);
    if (!passing.empty()) throw ConfigurationError(at_time(t) + passing);
    last = instants_.solve(t, {there, state.amplitude});
    return to_rate(last->solution);
  };
  const TimePoint now{state.now.t, state.now.state, to_rate(first.solution)};
  StepResult taken =
      take_step(now, state.steps, {shorter_on_error(within), shorter_on_error(at_end)});
  statistics_.totals.rejected_steps += taken.rejected;
  info.t = taken.step.end.t;
  info.dt = taken.step.dt();
  return {std::move(taken.step), std::move(taken.memory), std::move(*last), {}, info,
          std::move(taken.error)};
}

StepResult FreeSteps::take_step(const TimePoint& start, const StepMemory& memory,
                                const Rates& rates) const {
  const std::string dt_min = "time.dt_min = " + short_number(settings_.dt_min);
  try {
    return Stepper(settings_, rates).advance(start, memory, schedule_.next_event(start.t));
  } catch (const InadmissibleState& error) {
    throw ConfigurationError(std::string(error.what()) + "; steps down to " + dt_min +
                             " lead to it");
  } catch (const StepError& error) {
    throw SolverError(at_time(start.t) + error.what() + ", and steps are not to be shorter than " +
                      dt_min);
  }
}

}  // namespace stokesbook
