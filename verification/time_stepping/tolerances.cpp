// Compares the error with the tolerance.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;

namespace {

// Measures the largest error over some motions, and the average cost of each.
Measure errors(const std::vector<Motion>& motions, SteppingMethod method, double scale = 1.0) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? std::sqrt(10.0) : 10.0;
    for (double tolerance = 1e-3; tolerance > 0.9e-10; tolerance /= factor) {
      Measurement largest{.x = tolerance, .error = 0.0, .operations = 0.0};
      for (const Motion& motion : motions) {
        const RunResult run = run_to_tolerance(motion, method, tolerance, scale);
        largest.error = std::max(largest.error, run.error);
        largest.operations += run.evaluations / static_cast<double>(motions.size());
      }
      measurements.insert(measurements.begin(), largest);
    }
    return measurements;
  };
}

constexpr const char* in_proportion =
    "the error of a step is of one order more than its estimate: what adds up over 1 / h steps is "
    "in "
    "proportion to the tolerance";
constexpr const char* lower_order =
    "its estimate is the error of the lower order, a fifth of it: the orders are close enough that "
    "this stays within a factor 10 over seven decades";

// The runs start at these times, from the fast part of a half turn to the slow part. With a single
// start the error may be a hundredth of the tolerance, because errors in the few long steps of the
// pair 8(7) may cancel.
constexpr double starts[] = {0.0, 1.0, 2.5, 4.0, 6.0, 7.5, 9.0};

Line tolerance_line(const std::vector<Motion>& motions, SteppingMethod method,
                    const std::string& id, const std::string& reason) {
  const std::string names[] = {"Bogacki-Shampine 3(2)", "Dormand-Prince 5(4)",
                               "Prince-Dormand 8(7)"};
  const std::string keys[] = {"bogacki_shampine32", "dormand_prince54", "prince_dormand87"};
  const auto index = static_cast<std::size_t>(method) -
                     static_cast<std::size_t>(SteppingMethod::bogacki_shampine32);
  return {
      .key = keys[index],
      .label = names[index],
      .measure = errors(motions, method),
      .claim = Claim{.id = id,
                     .statement =
                         names[index] +
                         " has an error equal to the tolerance, within a factor 10 up and down.",
                     .law = ErrorBelowTolerance{10.0, 0.1},
                     .reason = reason,
                     .api = {"stokesbook::Stepper", "stokesbook::stepping_settings"}},
      .control = Control{"lengths and angles in a unit a hundred times too large",
                         errors(motions, method, 100.0)}};
}

}  // namespace

Experiment tolerances() {
  std::vector<Motion> jeffery;
  for (const double start : starts) jeffery.push_back(jeffery_in_shear(20.0, start));
  return {
      .key = "tolerance",
      .title = "Error by the tolerance: an ellipse 3:1 in shear, one turn, from seven angles",
      .x = "tolerance",
      .error = "largest error of the angle at the ends of steps, of all seven",
      .lines = {tolerance_line(jeffery, SteppingMethod::bogacki_shampine32, "09_17", in_proportion),
                tolerance_line(jeffery, SteppingMethod::dormand_prince54, "09_18", in_proportion),
                tolerance_line(jeffery, SteppingMethod::prince_dormand87, "09_19", lower_order)},
      .work_precision = true,
      .operation = "evaluations of the rate"};
}

// The errors are measured at t = 0.5, 1, ..., 12; for the pair 8(7) they are measured at 12.
Experiment tolerances_of_passing() {
  const std::vector<Motion> pair{passing()};
  return left_to_full(
      {.key = "tolerance_passing",
       .title = "Error by the tolerance: two circles that pass each other",
       .x = "tolerance",
       .error = "largest error of position, in radii, and angle",
       .lines = {tolerance_line(pair, SteppingMethod::dormand_prince54, "09_20", in_proportion),
                 tolerance_line(pair, SteppingMethod::prince_dormand87, "09_21", lower_order)},
       .work_precision = true,
       .operation = "solves"});
}

}  // namespace stokesbook::verification::time_stepping
