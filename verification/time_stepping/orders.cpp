// Measures the orders of all methods on motions with closed forms.
#include <cmath>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;

namespace {

// Holds a method, its order and its smallest number of steps.
struct Scheme {
  std::string key, label;
  SteppingMethod method;
  double order;
  int fewest_steps;
};

Scheme scheme(SteppingMethod method, int fewest_steps) {
  switch (method) {
    case SteppingMethod::euler:
      return {"euler", "Euler", method, 1.0, fewest_steps};
    case SteppingMethod::adams_bashforth2:
      return {"adams_bashforth2", "Adams-Bashforth 2", method, 2.0, fewest_steps};
    case SteppingMethod::heun:
      return {"heun", "Heun", method, 2.0, fewest_steps};
    case SteppingMethod::rk4:
      return {"rk4", "Runge-Kutta 4", method, 4.0, fewest_steps};
    case SteppingMethod::bogacki_shampine32:
      return {"bogacki_shampine32", "Bogacki-Shampine 3(2)", method, 3.0, fewest_steps};
    case SteppingMethod::dormand_prince54:
      return {"dormand_prince54", "Dormand-Prince 5(4)", method, 5.0, fewest_steps};
    default:
      return {"prince_dormand87", "Prince-Dormand 8(7)", method, 8.0, fewest_steps};
  }
}

Measure errors(const Motion& motion, const Scheme& scheme, const MakeRates& make_rates) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int k = 0; k <= (size == Size::full ? 5 : 3); ++k) {
      const auto steps =
          static_cast<int>(std::lround(scheme.fewest_steps * std::pow(2.0, 0.5 * k)));
      const RunResult run = run_equal_steps(motion, scheme.method, steps, make_rates);
      measurements.push_back(
          {.x = static_cast<double>(steps), .error = run.error, .operations = run.evaluations});
    }
    return measurements;
  };
}

// Returns the line with the claim about a scheme's order; `floor` is the level of rounding errors
// or of the solver's errors.
Line order_line(const Motion& motion, const Scheme& scheme, const std::string& id, double floor) {
  const bool has_stages =
      scheme.method != SteppingMethod::euler && scheme.method != SteppingMethod::adams_bashforth2;
  const MakeRates defective = has_stages ? frozen_stages : slow_rates;
  return {
      .key = scheme.key,
      .label = scheme.label,
      .measure = errors(motion, scheme, same_rates),
      .claim = Claim{.id = id,
                     .statement = scheme.label + " is of order " +
                                  std::to_string(static_cast<int>(scheme.order)) + ".",
                     .law = Algebraic{scheme.order, 0.2},
                     .window = {.floor = floor},
                     .reason = "the order conditions of its coefficients; a fifth for the terms "
                               "of higher order that are left at these steps",
                     .api = {"stokesbook::SteppingMethod"}},
      .control = Control{has_stages ? "all stages use the state at the start of the step"
                                    : "rates are one per cent too small",
                         errors(motion, scheme, defective)}};
}

}  // namespace

Experiment orders_in_shear() {
  const Motion motion = jeffery_in_shear(8.0);
  Motion at_end = motion;  // the few step ends do not show the largest error over time
  at_end.known_at = {8.0};
  return {
      .key = "shear",
      .title = "Orders: an ellipse 3:1 in shear",
      .x = "steps M",
      .error = "largest error of the angle at the ends of steps",
      .lines = {order_line(motion, scheme(SteppingMethod::euler, 400), "09_1", 1e-14),
                order_line(motion, scheme(SteppingMethod::adams_bashforth2, 200), "09_2", 1e-14),
                order_line(motion, scheme(SteppingMethod::heun, 200), "09_3", 1e-14),
                order_line(motion, scheme(SteppingMethod::rk4, 80), "09_4", 1e-14),
                order_line(motion, scheme(SteppingMethod::bogacki_shampine32, 100), "09_5", 1e-14),
                order_line(motion, scheme(SteppingMethod::dormand_prince54, 80), "09_6", 1e-14),
                order_line(at_end, scheme(SteppingMethod::prince_dormand87, 20), "09_7", 1e-14)},
      .operation = "evaluations of the rate"};
}

Experiment orders_in_extension() {
  const Motion motion = jeffery_in_extension(2.0);
  return {
      .key = "extension",
      .title = "Orders: an ellipse 3:1 in extension",
      .x = "steps M",
      .error = "largest error of the angle at the ends of steps",
      .lines = {order_line(motion, scheme(SteppingMethod::heun, 80), "09_8", 1e-14),
                order_line(motion, scheme(SteppingMethod::rk4, 40), "09_9", 1e-14),
                order_line(motion, scheme(SteppingMethod::dormand_prince54, 40), "09_10", 1e-14)},
      .operation = "evaluations of the rate"};
}

Experiment orders_of_circles() {
  const Motion motion = approaching_circles(1.0);
  return {
      .key = "circles",
      .title = "Orders: two circles that approach each other, by full solves",
      .x = "steps M",
      .error = "largest error of the distance at the ends of steps, in radii",
      .lines = {order_line(motion, scheme(SteppingMethod::rk4, 10), "09_11", 1e-11),
                order_line(motion, scheme(SteppingMethod::bogacki_shampine32, 20), "09_12", 1e-11),
                order_line(motion, scheme(SteppingMethod::dormand_prince54, 8), "09_13", 1e-11)},
      .operation = "solves"};
}

Experiment orders_of_passing() {
  Motion motion = passing();
  motion.known_at = {12.0};  // equal steps need not end at the other times
  return left_to_full(
      {.key = "passing",
       .title = "Orders: two circles that pass each other in shear, by full solves",
       .x = "steps M",
       .error = "error of position, in radii, and angle at t = 12",
       .lines = {order_line(motion, scheme(SteppingMethod::dormand_prince54, 80), "09_14", 1e-11),
                 {.key = "heun",
                  .label = "Heun",
                  .measure = errors(motion, scheme(SteppingMethod::heun, 120), same_rates)},
                 {.key = "rk4",
                  .label = "Runge-Kutta 4",
                  .measure = errors(motion, scheme(SteppingMethod::rk4, 60), same_rates)}},
       .operation = "solves"});
}

}  // namespace stokesbook::verification::time_stepping
