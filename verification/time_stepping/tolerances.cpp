// What a tolerance means: the error found for the error asked.
#include <cmath>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;

namespace {

Measure errors(const Motion& motion, Method method, double scale = 1.0) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? std::sqrt(10.0) : 10.0;
    for (double tolerance = 1e-3; tolerance > 0.9e-10; tolerance /= factor) {
      const RunResult run = run_to_tolerance(motion, method, tolerance, scale);
      measurements.insert(measurements.begin(),
                          {.x = tolerance, .error = run.error, .operations = run.evaluations});
    }
    return measurements;
  };
}

constexpr const char* in_proportion =
    "the error of a step is of one order more than its estimate: what adds up over 1 / h steps is "
    "in "
    "proportion to the tolerance";
constexpr const char* pessimistic = "as for the others, but its estimate is pessimistic";
constexpr const char* symmetric =
    "as for the ellipse, but errors before and after the encounter hide one another in part";

// What a line claims: errors between `least` and ten times what is asked.
struct Asked {
  std::string id;
  double least;
  std::string reason;
};

Line line(const Motion& motion, Method method, const Asked& asked) {
  const std::string names[] = {"Bogacki-Shampine 3(2)", "Dormand-Prince 5(4)",
                               "Prince-Dormand 8(7)"};
  const std::string keys[] = {"bogacki_shampine32", "dormand_prince54", "prince_dormand87"};
  const auto index =
      static_cast<std::size_t>(method) - static_cast<std::size_t>(Method::bogacki_shampine32);
  return {
      .key = keys[index],
      .label = names[index],
      .measure = errors(motion, method),
      .claim = Claim{.id = asked.id,
                     .statement = names[index] + " errs by ten times what is asked at most, and "
                                                 "not by far less.",
                     .law = ErrorBelowTolerance{10.0, asked.least},
                     .reason = asked.reason,
                     .api = {"stokesbook::Stepper", "stokesbook::stepping_settings"}},
      .control = Control{"lengths and angles in a unit a hundred times too large",
                         errors(motion, method, 100.0)}};
}

}  // namespace

Experiment tolerances() {
  const Motion jeffery = jeffery_in_shear(20.0);
  return {.key = "tolerance",
          .title = "Error found for the tolerance asked: an ellipse 3:1 in shear, one turn",
          .x = "tolerance",
          .error = "largest error of the angle at the ends of steps",
          .lines = {line(jeffery, Method::bogacki_shampine32, {"09_17", 0.1, in_proportion}),
                    line(jeffery, Method::dormand_prince54, {"09_18", 0.1, in_proportion}),
                    line(jeffery, Method::prince_dormand87, {"09_19", 0.02, pessimistic})},
          .work_precision = true,
          .operation = "evaluations of the rate"};
}

Experiment tolerances_of_passing() {
  const Motion pair = passing();
  return {.key = "tolerance_passing",
          .title = "Error found for the tolerance asked: two circles that pass each other",
          .x = "tolerance",
          .error =
              "largest error of position, in radii, and angle at t = 2, 4, ..., 12 (of the pair "
              "8(7) at 12)",
          .lines = {line(pair, Method::dormand_prince54, {"09_20", 0.02, symmetric}),
                    line(pair, Method::prince_dormand87, {"09_21", 0.02, pessimistic})},
          .work_precision = true,
          .operation = "solves"};
}

}  // namespace stokesbook::verification::time_stepping
