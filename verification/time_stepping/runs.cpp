#include "runs.hpp"

#include <algorithm>

namespace stokesbook::verification::time_stepping {

using Eigen::VectorXd;

namespace {

RunResult run(const Motion& motion, const SteppingSettings& settings,
              const std::function<double(double t)>& next_event, const MakeRates& make_rates) {
  const Counted counted(motion.rate);
  Moment now{0.0, motion.start, {}};
  now.rate = make_rates(counted.rate(), now).at_end(0.0, now.state);
  StepMemory memory;
  RunResult result;
  while (now.t < motion.t_final) {
    const Stepper stepper(settings, make_rates(counted.rate(), now));
    Advance advance = stepper.advance(now, std::move(memory), next_event(now.t));
    now = std::move(advance.step.end);
    memory = std::move(advance.memory);
    result.error = std::max(result.error, error_at(motion, now.t, now.state));
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

Rates same_rates(const Rate& rate, const Moment&) {
  return {rate, rate};
}

Rates frozen_stages(const Rate& rate, const Moment& start) {
  return {[=](double, const VectorXd&) { return rate(start.t, start.state); }, rate};
}

Rates slow_rates(const Rate& rate, const Moment&) {
  const Rate slow = [=](double t, const VectorXd& state) -> VectorXd {
    return 0.99 * rate(t, state);
  };
  return {slow, slow};
}

RunResult run_equal_steps(const Motion& motion, Method method, int steps,
                          const MakeRates& make_rates) {
  // No estimate is too large, and events say where steps end.
  const SteppingSettings settings{
      .method = method, .dt = motion.t_final, .bound = {1e9, VectorXd::Ones(motion.start.size())}};
  const auto next_end = [&](double t) {
    const double done = std::round(t / motion.t_final * steps);
    return motion.t_final * (done + 1.0) / steps;
  };
  return run(motion, settings, next_end, make_rates);
}

RunResult run_to_tolerance(const Motion& motion, Method method, double tolerance, double scale) {
  const SteppingSettings settings{
      .method = method, .bound = {0.5 * tolerance, VectorXd::Constant(motion.start.size(), scale)}};
  const auto next_known = [&](double t) {
    const auto later = std::ranges::upper_bound(motion.known_at, t);
    return later == motion.known_at.end() ? motion.t_final : *later;
  };
  return run(motion, settings, next_known, same_rates);
}

}  // namespace stokesbook::verification::time_stepping
