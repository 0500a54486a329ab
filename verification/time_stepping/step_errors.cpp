// Compares the sum of the steps' error estimates with the error at the end.
#include <cmath>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

enum class Taken { all_steps, last_step };

Measure errors(const Motion& motion, SteppingMethod method, int fewest_steps, Taken taken) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int k = 0; k <= (size == Size::full ? 5 : 3); ++k) {
      const RunResult run = run_equal_steps(motion, method, fewest_steps << k);
      const VectorXd& estimate = taken == Taken::all_steps ? run.estimate : run.last_estimate;
      measurements.insert(measurements.begin(), {.x = estimate.lpNorm<Eigen::Infinity>(),
                                                 .error = run.error,
                                                 .operations = run.evaluations});
    }
    return measurements;
  };
}

Line estimate_line(const Motion& motion, SteppingMethod method, const std::string& key,
                   const std::string& label, int fewest_steps, const std::string& id) {
  return {.key = key,
          .label = label,
          .measure = errors(motion, method, fewest_steps, Taken::all_steps),
          .claim = Claim{.id = id,
                         .statement = "The sum of the error estimates of all steps of " + label +
                                      " is the error at the end, within a factor 10 up and down.",
                         .law = ErrorBelowTolerance{10.0, 0.1},
                         .reason = "the estimate of a step is its error but for the next order; "
                                   "a factor for what the flow makes of it until the end",
                         .api = {"stokesbook::adams_moulton_error"}},
          .control = Control{"the estimate of the last step alone",
                             errors(motion, method, fewest_steps, Taken::last_step)}};
}

Motion known_at_its_end(Motion motion) {
  motion.known_at = {motion.t_final};
  return motion;
}

}  // namespace

Experiment step_errors() {
  const Motion motion = known_at_its_end(jeffery_in_shear(8.0));
  return {.key = "step_errors",
          .title = "Error by the estimated error, fixed steps: an ellipse 3:1 in shear",
          .x = "sum of the estimates of all steps Σδ",
          .error = "error of the angle at the end",
          .lines = {estimate_line(motion, SteppingMethod::euler, "euler", "Euler", 200, "09_36"),
                    estimate_line(motion, SteppingMethod::adams_bashforth2, "adams_bashforth2",
                                  "Adams-Bashforth 2", 100, "09_37"),
                    estimate_line(motion, SteppingMethod::heun, "heun", "Heun", 100, "09_38")},
          .operation = "evaluations of the rate"};
}

}  // namespace stokesbook::verification::time_stepping
