// Measures the cost of steps at tolerances below the noise of the rates. Rates have noise if solves
// stop at a tolerance.
#include <cmath>
#include <memory>
#include <random>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

constexpr double noise = 1e-5;

Motion noisy(Motion motion) {
  const auto random = std::make_shared<std::mt19937>(1);
  const Rate exact = motion.rate;
  motion.rate = [=](double t, const VectorXd& q) -> VectorXd {
    const double part = std::uniform_real_distribution(-noise, noise)(*random);
    return exact(t, q).array() + part;
  };
  return motion;
}

Measure evaluations(SteppingMethod method, bool has_noise) {
  return [=](Size size) {
    const Motion exact = jeffery_in_shear(8.0);
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? std::pow(10.0, 0.25) : std::sqrt(10.0);
    for (double tolerance = 1e-8 / std::sqrt(10.0); tolerance < 1.1e-3; tolerance *= factor) {
      const RunResult run = run_to_tolerance(has_noise ? noisy(exact) : exact, method, tolerance);
      measurements.push_back(
          {.x = tolerance, .error = run.evaluations, .operations = run.evaluations});
    }
    return measurements;
  };
}

Line noise_line(const std::string& key, const std::string& label, SteppingMethod method,
                const std::string& id) {
  return {.key = key,
          .label = label + ", rates with noise",
          .measure = evaluations(method, true),
          .claim = Claim{.id = id,
                         .statement = "Below the noise of the rates " + label +
                                      " takes steps of a length in proportion to the tolerance.",
                         .law = Cost{-1.0, 0.2},
                         .window = {.to = 5e-3 * noise},
                         .reason = "noise leaves a tenth of h times itself in the estimate of a "
                                   "step, whatever the order: it is met by a shorter h; at 5e-8 "
                                   "by less than half of what the order asks for",
                         .api = {"stokesbook::Stepper"}},
          .control = Control{"no noise", evaluations(method, false)}};
}

}  // namespace

Experiment noisy_rates() {
  return {.key = "noise",
          .title = "Rates with noise of 1e-5, an ellipse 3:1 in shear",
          .x = "tolerance",
          .error = "evaluations of the rate",
          .lines = {noise_line("dormand_prince54", "Dormand-Prince 5(4)",
                               SteppingMethod::dormand_prince54, "09_27"),
                    noise_line("prince_dormand87", "Prince-Dormand 8(7)",
                               SteppingMethod::prince_dormand87, "09_28"),
                    {.key = "exact_54",
                     .label = "Dormand-Prince 5(4), no noise",
                     .measure = evaluations(SteppingMethod::dormand_prince54, false)},
                    {.key = "exact_87",
                     .label = "Prince-Dormand 8(7), no noise",
                     .measure = evaluations(SteppingMethod::prince_dormand87, false)}},
          .operation = "evaluations of the rate"};
}

}  // namespace stokesbook::verification::time_stepping
