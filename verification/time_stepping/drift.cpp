// Measures the error of the angle over a hundred turns of an ellipse in shear.
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

constexpr double turn = 2.0 * std::numbers::pi * (3.0 + 1.0 / 3.0);

// A planted defect: the rate grows by a millionth of itself in each turn.
Motion hastening(Motion motion) {
  const Rate exact = motion.rate;
  motion.rate = [=](double t, const VectorXd& q) -> VectorXd {
    return (1.0 + 1e-6 * t / turn) * exact(t, q);
  };
  return motion;
}

// Measures the errors of the angle after 1, 2, 5, ... turns of one run.
Measure errors(SteppingMethod method, double tolerance, bool hastens = false) {
  return [=](Size) {
    const Motion exact = jeffery_in_shear(100.0 * turn);
    const Motion motion = hastens ? hastening(exact) : exact;
    const Counted counted(motion.rate);
    const SteppingSettings settings{
        .method = method, .dt = turn / 100.0, .bound = {tolerance, VectorXd::Ones(1)}};
    const Stepper stepper(settings, {counted.rate(), counted.rate()});
    TimePoint now{0.0, motion.start, motion.rate(0.0, motion.start)};
    StepMemory memory;
    std::vector<Measurement> measurements;
    for (const int turns : {1, 2, 5, 10, 20, 50, 100}) {
      while (now.t < turns * turn) {
        StepResult taken = stepper.advance(now, memory, turns * turn);
        now = std::move(taken.step.end);
        memory = std::move(taken.memory);
      }
      // After whole turns the exact angle is known without rounding errors of the formula.
      const double error = std::abs(now.state[0] + 2.0 * std::numbers::pi * turns);
      measurements.push_back(
          {.x = static_cast<double>(turns), .error = error, .operations = counted.evaluations()});
    }
    return measurements;
  };
}

Line drift_line(const std::string& key, const std::string& label, SteppingMethod method,
                double tolerance, const std::string& id) {
  return {
      .key = key,
      .label = label,
      .measure = errors(method, tolerance),
      .claim = Claim{.id = id,
                     .statement = label + ": the phase drifts in proportion to time.",
                     .law = Algebraic{-1.0, 0.1},
                     .reason = "steps repeat from turn to turn, and with them their errors; the "
                               "orbit is closed, so that an error of phase does not grow by "
                               "itself",
                     .api = {"stokesbook::Stepper"}},
      .control =
          Control{"a rate that grows by a millionth a turn", errors(method, tolerance, true)}};
}

}  // namespace

Experiment drift() {
  return {.key = "drift",
          .title = "A hundred turns of an ellipse 3:1 in shear",
          .x = "turns k",
          .error = "error of the angle",
          .lines = {{.key = "euler",
                     .label = "Euler, 100 steps a turn",
                     .measure = errors(SteppingMethod::euler, 1.0)},
                    drift_line("rk4", "Runge-Kutta 4, 100 steps a turn", SteppingMethod::rk4, 1.0,
                               "09_23"),
                    drift_line("dormand_prince54", "Dormand-Prince 5(4), tolerance 1e-8",
                               SteppingMethod::dormand_prince54, 1e-8, "09_24"),
                    {.key = "prince_dormand87",
                     .label = "Prince-Dormand 8(7), tolerance 1e-8",
                     .measure = errors(SteppingMethod::prince_dormand87, 1e-8)}},
          .operation = "evaluations of the rate"};
}

}  // namespace stokesbook::verification::time_stepping
