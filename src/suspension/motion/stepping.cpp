// Connects the solver with the time steppers (chapter 09): packs the motions of a solution as a
// rate, translates the settings of a scene, and packs the memory of the steps for checkpoints.
#include "suspension/motion/stepping.hpp"

#include <algorithm>
#include <limits>

#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Returns the largest distance of a body's boundary from its position; 1 if there are no bodies.
double largest_radius(const SuspensionSolver& solver) {
  double radius = 0.0;
  for (std::size_t k = 0; k < solver.scene().bodies.size(); ++k) {
    radius = std::max(radius, bounding_radius(solver.discretisation()[k]->curve, 0.0));
  }
  return radius > 0.0 ? radius : 1.0;
}

// Allowed error of a step, over the allowed error of a run. Errors add up if the flow does not
// contract; with half of the allowed error for each step, runs of ten and twenty units of time stay
// within their allowed error.
constexpr double error_of_a_step = 0.5;

VectorXd one(double number) {
  return VectorXd::Constant(1, number);
}

}  // namespace

VectorXd to_rate(const Solution& solution) {
  Configuration rate;
  for (const auto& [velocity, omega] : solution.motions) rate.push_back({velocity, omega});
  return to_state(rate);
}

double step_tolerance(const TimeSettings& time) {
  return time.tolerance.value_or(default_step_tolerance);
}

double largest_distance(const Discretisation& discretisation, const Configuration& p,
                        const Configuration& q) {
  double largest = 0.0;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    // c + e^{i theta} X for the nodes X in the frame of the shape.
    const auto at = [&](const Pose& pose) {
      return (pose.position +
              std::polar(1.0, pose.orientation) * discretisation[k]->curve.x.array())
          .eval();
    };
    largest = std::max(largest, (at(p[k]) - at(q[k])).abs().maxCoeff());
  }
  return largest;
}

SteppingSettings stepping_settings(const SuspensionSolver& solver) {
  const TimeSettings time = solver.scene().time.value_or(TimeSettings{});
  SteppingSettings settings{.method = time.method, .dt = time.dt};
  const double none = std::numeric_limits<double>::infinity();
  const double longest =
      std::min({time.t_final, time.dt.value_or(none), time.dt_max.value_or(none)});
  settings.dt_min = time.dt_min.value_or(1e-6 * longest);
  if (time.dt_max) settings.dt_max = *time.dt_max;
  Configuration scale(solver.discretisation().size(),
                      {largest_radius(solver) * Complex{1.0, 1.0}, 1.0});
  settings.bound = {error_of_a_step * step_tolerance(time), to_state(scale)};
  return settings;
}

History to_history(const StepMemory& memory) {
  History history{{"error", one(memory.error)}};
  if (memory.dt) history["dt"] = one(*memory.dt);
  if (memory.previous) {
    history["previous_dt"] = one(memory.previous->dt);
    history["previous_rate"] = memory.previous->rate;
  }
  if (memory.reduced) {
    history["detour_end"] = one(memory.reduced->until);
    history["detour_dt"] = one(memory.reduced->dt_after);
  }
  return history;
}

StepMemory to_memory(const History& history) {
  const auto number = [&](const char* name) { return history.at(name)[0]; };
  StepMemory memory{.error = number("error")};
  if (history.contains("dt")) memory.dt = number("dt");
  if (history.contains("previous_dt")) {
    memory.previous = PreviousStep{number("previous_dt"), history.at("previous_rate")};
  }
  if (history.contains("detour_end")) {
    memory.reduced = ReducedSteps{number("detour_end"), number("detour_dt")};
  }
  return memory;
}

}  // namespace stokesbook
