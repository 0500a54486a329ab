// Runs two disks in a shear flow that reverses: Stokes flow returns along its path, so the distance
// from the start is the error of the time steps.
#include <cmath>
#include <limits>
#include <map>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

constexpr double reversal_time = 20.0;

// Returns the published scene, with radius 1/2 and the initial centres (-8, height) and (0, 0). The
// gap is always at least 1/6; for such gaps 40 nodes suffice to 1e-6, and 64 to 1e-11.
Scene two_disks(double height, double tolerance) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  for (const Complex position : {Complex{-8.0, height}, Complex{}}) {
    scene.bodies.push_back(
        {.shape = Circle{0.5}, .position = position, .n_nodes = tolerance < 1e-9 ? 64 : 40});
  }
  scene.solver.tolerance = tolerance;
  return scene;
}

// Runs a motion to its end.
using Run = std::function<RunResult(const Motion& motion)>;

// Holds the error, which is the distance of all centres from their start relative to the norm of
// their start, and the cost, which is the number of solves.
struct ThereAndBack {
  double error = 0.0;
  double solves = 0.0;
};

ThereAndBack there_and_back(const Scene& scene, const Run& run) {
  const Rate rate = solved_rate(scene);
  const auto nothing = [](const VectorXd& state) -> VectorXd { return 0.0 * state; };
  const auto zero = [](double) -> VectorXd { return VectorXd::Zero(6); };
  const VectorXd start = start_of(scene);
  const RunResult there = run({rate, start, reversal_time, zero, nothing});
  const Rate reversed = [=](double t, const VectorXd& q) -> VectorXd { return -rate(t, q); };
  const RunResult back = run({reversed, there.state, reversal_time, zero, nothing});
  const auto centres = [](const VectorXd& q) { return VectorXd{{q[0], q[1], q[3], q[4]}}; };
  return {(centres(back.state) - centres(start)).norm() / centres(start).norm(),
          there.evaluations + back.evaluations};
}

Run equal_steps(SteppingMethod method, int steps) {
  return [=](const Motion& motion) { return run_equal_steps(motion, method, steps); };
}

Run to_tolerance(SteppingMethod method, double tolerance) {
  // The tolerance is measured in radii.
  return [=](const Motion& motion) { return run_to_tolerance(motion, method, tolerance, 0.5); };
}

Measurement measurement(const ThereAndBack& found) {
  return {.x = found.solves, .error = found.error, .operations = found.solves};
}

Measure fixed_errors(SteppingMethod method, int fewest) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int k = 0; k < (size == Size::full ? 4 : 3); ++k) {
      measurements.push_back(
          measurement(there_and_back(two_disks(0.5, 1e-6), equal_steps(method, fewest << k))));
    }
    return measurements;
  };
}

Measure adapted_errors(SteppingMethod method) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? 10.0 : 100.0;
    for (double tolerance = 1e-4; tolerance > 0.9e-8; tolerance /= factor) {
      measurements.push_back(
          measurement(there_and_back(two_disks(0.5, 1e-11), to_tolerance(method, tolerance))));
    }
    return measurements;
  };
}

// Returns the number of solves for an error, extrapolated from a run of 200 steps by the known
// order.
double solves_of_order(double height, SteppingMethod method, double error, double order) {
  const ThereAndBack found = there_and_back(two_disks(height, 1e-6), equal_steps(method, 200));
  return found.solves * std::pow(found.error / error, 1.0 / order);
}

// Returns the number of solves that Euler's method takes for 1e-2. The result is stored because it
// is expensive and used twice.
double solves_of_euler(double height) {
  static std::map<double, double> known;
  const auto [found, is_new] = known.try_emplace(height);
  if (is_new) found->second = solves_of_order(height, SteppingMethod::euler, 1e-2, 1.0);
  return found->second;
}

// Returns the number of solves of the pair 5(4) at a tolerance for which the disks return to within
// 1e-8, or infinity if they do not return so closely.
double solves_of_pair(double height) {
  const ThereAndBack found = there_and_back(two_disks(height, 1e-11),
                                            to_tolerance(SteppingMethod::dormand_prince54, 3e-8));
  return found.error <= 1e-8 ? found.solves : std::numeric_limits<double>::infinity();
}

// Measures the number of solves for 1e-8 relative to that of Euler's method for 1e-2, by the
// initial height of the first disk.
Measure ratios(const std::function<double(double height)>& solves) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double height : {0.5, 0.6, 0.75}) {
      measurements.push_back({.x = height, .error = solves(height) / solves_of_euler(height)});
    }
    return measurements;
  };
}

}  // namespace

Experiment reversal() {
  return {
      .key = "reversal",
      .title = "Two disks in reversed shear, without contact",
      .x = "solves E",
      .error = "distance of the centres from their start, relative",
      .lines = {{.key = "euler",
                 .label = "Euler",
                 .measure = fixed_errors(SteppingMethod::euler, 100)},
                {.key = "heun", .label = "Heun", .measure = fixed_errors(SteppingMethod::heun, 50)},
                {.key = "dormand_prince54",
                 .label = "Dormand-Prince 5(4)",
                 .measure = adapted_errors(SteppingMethod::dormand_prince54)},
                {.key = "prince_dormand87",
                 .label = "Prince-Dormand 8(7)",
                 .measure = adapted_errors(SteppingMethod::prince_dormand87)}},
      .work_precision = true,
      .operation = "solves"};
}

Experiment reversal_costs() {
  return left_to_full(
      {.key = "reversal_costs",
       .title = "Solves for 1e-8 over those of Euler for 1e-2, two disks in reversed shear",
       .x = "height of the first disk, y",
       .error = "ratio of solves",
       .lines = {
           {.key = "dormand_prince54",
            .label = "Dormand-Prince 5(4)",
            .measure = ratios(solves_of_pair),
            .claim = Claim{.id = "09_22",
                           .statement = "Six more digits take fewer solves than Euler takes for "
                                        "two.",
                           .law = AtMost{1.0},
                           .reason = "orders 5 and 1: six digits cost the pair a factor of 16, "
                                     "Euler a million",
                           .api = {"stokesbook::Stepper", "stokesbook::dormand_prince54"}},
            .control = Control{"Heun's scheme in its place", ratios([](double height) {
                                 return solves_of_order(height, SteppingMethod::heun, 1e-8,
                                                        3.0);  // claim 09_25
                               })}}}});
}

}  // namespace stokesbook::verification::time_stepping
