// Runs motions by the steppers, and measures errors and costs.
#include "runs.hpp"

#include <algorithm>

namespace stokesbook::verification::time_stepping {

using Eigen::VectorXd;

namespace {

// Returns the largest error at the end of a step and, if the step has an interpolant, at the known
// times within the step.
double error_of(const Motion& motion, SteppingMethod method, const Step& step) {
  double error = error_at(motion, step.end.t, step.end.state);
  if (!has_dense_output(method)) return error;
  for (const double t : motion.known_at) {
    if (t <= step.start.t || t >= step.end.t) continue;
    error = std::max(error, error_at(motion, t, interpolate(step, t)));
  }
  return error;
}

RunResult run(const Motion& motion, const SteppingSettings& settings,
              const std::function<double(double t)>& next_event, const MakeRates& make_rates) {
  const Counted counted(motion.rate);
  TimePoint now{0.0, motion.start, {}};
  now.rate = make_rates(counted.rate(), now).at_end(0.0, now.state);
  StepMemory memory;
  RunResult result;
  result.estimate = VectorXd::Zero(motion.start.size());
  while (now.t < motion.t_final) {
    const Stepper stepper(settings, make_rates(counted.rate(), now));
    StepResult taken = stepper.advance(now, std::move(memory), next_event(now.t));
    result.error = std::max(result.error, error_of(motion, settings.method, taken.step));
    result.estimate += taken.error;
    result.last_estimate = std::move(taken.error);
    now = std::move(taken.step.end);
    memory = std::move(taken.memory);
  }
  result.evaluations = counted.evaluations();
  result.state = now.state;
  return result;
}

}  // namespace

double error_at(const Motion& motion, double t, const VectorXd& state) {
  const std::vector<double>& known = motion.known_at;
  if (!known.empty() && std::ranges::find(known, t) == known.end()) return 0.0;
  const VectorXd error = motion.compared(state) - motion.exact(t);
  return error.lpNorm<Eigen::Infinity>();
}

Rate Counted::rate() const {
  return [rate = rate_, count = count_](double t, const VectorXd& state) {
    ++*count;
    return rate(t, state);
  };
}

Rates same_rates(const Rate& rate, const TimePoint&) {
  return {rate, rate};
}

Rates frozen_stages(const Rate& rate, const TimePoint& start) {
  return {[=](double, const VectorXd&) { return rate(start.t, start.state); }, rate};
}

Rates slow_rates(const Rate& rate, const TimePoint&) {
  const Rate slow = [=](double t, const VectorXd& state) -> VectorXd {
    return 0.99 * rate(t, state);
  };
  return {slow, slow};
}

RunResult run_equal_steps(const Motion& motion, SteppingMethod method, int steps,
                          const MakeRates& make_rates) {
  // No error estimate is too large for these settings; the step ends are given by events.
  const SteppingSettings settings{
      .method = method, .dt = motion.t_final, .bound = {1e9, VectorXd::Ones(motion.start.size())}};
  const auto next_end = [&](double t) {
    const double done = std::round(t / motion.t_final * steps);
    return motion.t_final * (done + 1.0) / steps;
  };
  return run(motion, settings, next_end, make_rates);
}

RunResult run_to_tolerance(const Motion& motion, SteppingMethod method, double tolerance,
                           double scale) {
  const SteppingSettings settings{
      .method = method, .bound = {0.5 * tolerance, VectorXd::Constant(motion.start.size(), scale)}};
  return run(
      motion, settings, [&](double) { return motion.t_final; }, same_rates);
}

}  // namespace stokesbook::verification::time_stepping
