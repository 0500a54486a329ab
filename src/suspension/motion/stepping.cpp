// Connects the solver with the time steppers (chapter 09): translates the settings of a scene.
#include "suspension/motion/stepping.hpp"

#include <algorithm>
#include <limits>

#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

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

}  // namespace

SteppingSettings stepping_settings(const SuspensionSolver& solver, Eigen::Index entries) {
  const TimeSettings time = solver.scene().time.value_or(TimeSettings{});
  SteppingSettings settings{.method = time.method, .dt = time.dt};
  const double none = std::numeric_limits<double>::infinity();
  const double longest =
      std::min({time.t_final, time.dt.value_or(none), time.dt_max.value_or(none)});
  settings.dt_min = time.dt_min.value_or(1e-6 * longest);
  if (time.dt_max) settings.dt_max = *time.dt_max;
  if (adapts_steps(time)) {
    // Error estimates do not see what happens between the stages of a step.
    settings.dt_max = std::min(settings.dt_max, 0.25 * shortest_period(solver.scene()));
    if (settings.dt) settings.dt = std::min(*settings.dt, settings.dt_max);
  }
  const double radius = largest_radius(solver);
  const Configuration unit(solver.discretisation().size(), {radius * Complex{1.0, 1.0}, 1.0});
  VectorXd scale = VectorXd::Constant(entries, radius);
  scale.head(3 * std::ssize(unit)) = to_state(unit);
  settings.bound = {error_of_a_step * time.tolerance.value_or(default_step_tolerance), scale};
  return settings;
}

}  // namespace stokesbook
