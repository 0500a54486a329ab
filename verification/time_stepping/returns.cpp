// Measures the orders of the error after a reversal: methods of even order cancel a part of their
// errors on the way back.
#include <cmath>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

/// Selects the compared state: after the way there and back, or (for the control) after the way
/// there.
enum class Way { there_and_back, there };

double error(SteppingMethod method, int steps, Way way) {
  const Motion motion = jeffery_in_shear(8.0);
  const RunResult there = run_equal_steps(motion, method, steps);
  if (way == Way::there) return (there.state - motion.exact(motion.t_final)).norm();
  Motion back = motion;
  back.rate = [&](double t, const VectorXd& q) -> VectorXd { return -motion.rate(t, q); };
  back.start = there.state;
  return (run_equal_steps(back, method, steps).state - motion.start).norm();
}

Measure errors(SteppingMethod method, Way way) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int steps = 25; steps <= (size == Size::full ? 800 : 200); steps *= 2) {
      measurements.push_back({.x = static_cast<double>(steps), .error = error(method, steps, way)});
    }
    return measurements;
  };
}

Line return_line(const std::string& key, const std::string& label, SteppingMethod method,
                 double order, const std::string& id) {
  return {.key = key,
          .label = label,
          .measure = errors(method, Way::there_and_back),
          .claim = Claim{.id = id,
                         .statement = label + " returns to the start with an error of order " +
                                      std::to_string(static_cast<int>(order)) + ".",
                         .law = Algebraic{order, 0.2},
                         .window = {.from = 50.0, .floor = 1e-14},
                         .reason = "a step of the reversed flow is a step with -h: of errors "
                                   "c h^(p+1) and c (-h)^(p+1), p even, the sum is of one order "
                                   "more",
                         .api = {"stokesbook::SteppingMethod"}},
          .control = Control{"compared at the turning point", errors(method, Way::there)}};
}

}  // namespace

Experiment returns() {
  return {.key = "returns",
          .title = "There and back: an ellipse 3:1 in shear that is reversed",
          .x = "steps each way M",
          .error = "distance of the angle from the start",
          .lines = {{.key = "euler",
                     .label = "Euler",
                     .measure = errors(SteppingMethod::euler, Way::there_and_back)},
                    return_line("heun", "Heun", SteppingMethod::heun, 3.0, "09_25"),
                    {.key = "bogacki_shampine32",
                     .label = "Bogacki-Shampine 3(2)",
                     .measure = errors(SteppingMethod::bogacki_shampine32, Way::there_and_back)},
                    return_line("rk4", "Runge-Kutta 4", SteppingMethod::rk4, 5.0, "09_26")}};
}

}  // namespace stokesbook::verification::time_stepping
