// Measures the number of solves for a given accuracy, by every stepper.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "multistep.hpp"
#include "support/once.hpp"
#include "suspension/motion/simulation.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;

namespace {

Measurement measurement(const RunResult& run) {
  return {.x = run.evaluations, .error = run.error, .operations = run.evaluations};
}

using MakeMotion = Motion (*)();

// Each motion is made once, because its reference takes longer than the runs.
const Motion& made(MakeMotion make) {
  static test::Once<MakeMotion, Motion> motions;
  return motions(make, [&] { return make(); });
}

Measure equal_steps(MakeMotion make, SteppingMethod method, int fewest) {
  return [=](Size size) {
    const Motion& motion = made(make);
    std::vector<Measurement> measurements;
    for (int k = 0; k < (size == Size::full ? 5 : 3); ++k) {
      measurements.push_back(measurement(run_equal_steps(motion, method, fewest << k)));
    }
    return measurements;
  };
}

Measure adapted(MakeMotion make,
                const std::function<RunResult(const Motion& motion, double tolerance)>& run,
                double tightest) {
  return [=](Size size) {
    const Motion& motion = made(make);
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? std::sqrt(10.0) : 10.0;
    for (double tolerance = 1e-3; tolerance > 0.9 * tightest; tolerance /= factor) {
      measurements.push_back(measurement(run(motion, tolerance)));
    }
    // The multistep method may take fewer evaluations for a tighter tolerance.
    std::ranges::sort(measurements, {}, &Measurement::x);
    return measurements;
  };
}

Measure embedded(MakeMotion make, SteppingMethod method, double tightest) {
  return adapted(
      make,
      [=](const Motion& motion, double tolerance) {
        return run_to_tolerance(motion, method, tolerance);
      },
      tightest);
}

// Runs Euler's method with steps that the solver's effort controls, for shorter and shorter first
// and longest steps.
std::vector<Measurement> by_effort(Size size) {
  const Motion& motion = made(passing);
  std::vector<Measurement> measurements;
  for (int k = 0; k < (size == Size::full ? 5 : 3); ++k) {
    Scene scene = passing_circles();
    const double longest = 0.4 / (1 << k);
    scene.time = TimeSettings{
        .t_final = motion.t_final, .dt = longest / 4.0, .method = SteppingMethod::euler};
    scene.time->dt_min = longest / 16.0;
    scene.time->dt_max = longest;
    scene.time->effort = EffortBounds{9, 11};
    scene.output.dt_write = 2.0;
    RunResult run;
    Observer observer;
    observer.checkpoint = [&](const Checkpoint& reached) {
      run.error = std::max(run.error, error_at(motion, reached.t, reached.state));
    };
    const SuspensionSolver solver(scene);
    Simulation simulation(solver, observer);
    simulation.run();
    run.evaluations = static_cast<double>(simulation.totals().solves);
    measurements.push_back(measurement(run));
  }
  return measurements;
}

std::vector<Line> lines_of(MakeMotion make, int fewest) {
  return {{.key = "euler",
           .label = "Euler",
           .measure = equal_steps(make, SteppingMethod::euler, 4 * fewest)},
          {.key = "adams_bashforth2",
           .label = "Adams-Bashforth 2",
           .measure = equal_steps(make, SteppingMethod::adams_bashforth2, 4 * fewest)},
          {.key = "rk4",
           .label = "Runge-Kutta 4",
           .measure = equal_steps(make, SteppingMethod::rk4, fewest)},
          {.key = "dormand_prince54",
           .label = "Dormand-Prince 5(4)",
           .measure = embedded(make, SteppingMethod::dormand_prince54, 1e-5)},
          {.key = "prince_dormand87",
           .label = "Prince-Dormand 8(7)",
           .measure = embedded(make, SteppingMethod::prince_dormand87, 1e-5)}};
}

}  // namespace

// The errors are measured at those of the times t = 2, 4, ..., 12 at which a step ends.
Experiment work() {
  return {
      .key = "work",
      .title = "What an accuracy costs: two circles that pass each other",
      .x = "solves E",
      .error = "largest error of position, in radii, and angle",
      .lines = {{.key = "euler",
                 .label = "Euler",
                 .measure = equal_steps(passing, SteppingMethod::euler, 102)},
                {.key = "effort", .label = "Euler, steps by solver effort", .measure = by_effort},
                {.key = "adams_bashforth2",
                 .label = "Adams-Bashforth 2",
                 .measure = equal_steps(passing, SteppingMethod::adams_bashforth2, 84)},
                {.key = "heun",
                 .label = "Heun",
                 .measure = equal_steps(passing, SteppingMethod::heun, 42)},
                {.key = "rk4",
                 .label = "Runge-Kutta 4",
                 .measure = equal_steps(passing, SteppingMethod::rk4, 24)},
                {.key = "bogacki_shampine32",
                 .label = "Bogacki-Shampine 3(2)",
                 .measure = embedded(passing, SteppingMethod::bogacki_shampine32, 1e-5)},
                {.key = "dormand_prince54",
                 .label = "Dormand-Prince 5(4)",
                 .measure = embedded(passing, SteppingMethod::dormand_prince54, 1e-9)},
                {.key = "prince_dormand87",
                 .label = "Prince-Dormand 8(7)",
                 .measure = embedded(passing, SteppingMethod::prince_dormand87, 1e-9)},
                {.key = "multistep",
                 .label = "GSL's Adams of variable order",
                 .measure = adapted(passing, run_multistep, 1e-9)}},
      .work_precision = true,
      .operation = "solves"};
}

Experiment work_of_nine() {
  return {.key = "work_of_nine",
          .title = "What an accuracy costs: nine circles in shear",
          .x = "solves E",
          .error = "largest error of a position or angle at t = 2",
          .lines = lines_of(nine_circles, 5),
          .work_precision = true,
          .operation = "solves"};
}

Experiment work_of_cell() {
  return left_to_full({.key = "work_of_cell",
                       .title = "What an accuracy costs: six ellipses in a Couette cell",
                       .x = "solves E",
                       .error = "largest error of a position or angle at t = 1",
                       .lines = lines_of(couette_cell, 3),
                       .work_precision = true,
                       .operation = "solves"});
}

}  // namespace stokesbook::verification::time_stepping
