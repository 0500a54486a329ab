// Measures the truncation errors of whole sums by the order, and by the tolerance that selects the
// order.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::fmm {

using namespace study;

namespace {

using Set = const Summed& (*)();

/// Holds an error of a sum, and the power of p in this error. A derivative multiplies the k-th
/// power's term by k.
struct Quantity {
  double (*error)(const Summed&, const FmmSettings&);
  double power;
};
constexpr Quantity velocity_sum{velocity_error, 0.0}, derivative_sum{derivative_error, 1.0},
    point_force_sum{point_force_error, 0.0};

/// Measures errors by the order. The tree is the same for all orders, with boxes of at most 80
/// nodes.
Measure over_orders(Set set, const Quantity& quantity, int most) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int p = 4; p <= 44; p += size == Size::full ? 1 : 2) {
      measurements.push_back(
          {.x = static_cast<double>(p), .error = quantity.error(set(), {std::min(p, most), 80})});
    }
    return measurements;
  };
}

Line order_line(const std::string& key, const std::string& id, const std::string& label, Set set,
                const Quantity& quantity) {
  return {
      .key = key,
      .label = label,
      .measure = over_orders(set, quantity, 60),
      .claim = Claim{.id = id,
                     .statement = "Errors of the sum fall by ten each three orders " + label + ".",
                     .law = Geometric{std::log(10.0) / 3.03, 0.09, quantity.power},
                     .window = {.floor = 1e-15},
                     .reason = "ln 2, the lower edge, for pairs of boxes that are just "
                               "separated, of which there are few; ten each 3.03 orders is "
                               "what the choice of the order counts on",
                     .api = {"stokesbook::Fmm", "stokesbook::FmmSettings"}},
      .control = Control{"no order beyond 10", over_orders(set, quantity, 10)}};
}

using Choice = FmmSettings (*)(double tolerance);

/// A planted defect: the order is that for half of the digits.
FmmSettings for_half_of_the_digits(double tolerance) {
  return FmmSettings::for_tolerance(std::sqrt(tolerance));
}

Measure over_tolerances(Set set, const Quantity& quantity, Choice choice) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const int step = size == Size::full ? 1 : 3;
    for (int digits = 12; digits >= 3; digits -= step) {
      const double tolerance = std::pow(10.0, -digits);
      measurements.push_back({.x = tolerance, .error = quantity.error(set(), choice(tolerance))});
    }
    return measurements;
  };
}

Line tolerance_line(const std::string& key, const std::string& id, const std::string& label,
                    Set set, const Quantity& quantity, const ErrorBelowTolerance& law) {
  return {.key = key,
          .label = label,
          .measure = over_tolerances(set, quantity, FmmSettings::for_tolerance),
          .claim = Claim{.id = id,
                         .statement = "The order chosen for a tolerance meets it " + label + ".",
                         .law = law,
                         .reason = "the order is that of velocities at one slender body, "
                                   "the worst case; random sets are up to a hundred times "
                                   "better, and more so derivatives, in which the near field is "
                                   "larger, and Stokeslets, whose series is the integral of "
                                   "the layer's",
                         .api = {"stokesbook::Fmm", "stokesbook::FmmSettings::for_tolerance"}},
          .control = Control{"the order of half of the digits",
                             over_tolerances(set, quantity, for_half_of_the_digits)}};
}

}  // namespace

Experiment orders() {
  return {
      .key = "orders",
      .title = "Velocities of 5000 nodes",
      .x = "order p",
      .error = "error of the velocity in the 2-norm, relative",
      .axes = Axes::semi_log,
      .lines = {
          order_line("square", "08_9", "at nodes uniform in a square", summed_square, velocity_sum),
          order_line("ellipses", "08_10", "at nodes on ellipses", summed_ellipses, velocity_sum),
          order_line("crowd", "08_11", "at nodes crowding over eight decades", summed_crowd,
                     velocity_sum)}};
}

Experiment derivative_orders() {
  return {.key = "derivatives",
          .title = "Pressure, vorticity and strain of 5000 nodes",
          .x = "order p",
          .error = "error of the three beside the nodes in the 2-norm, relative",
          .axes = Axes::semi_log,
          .lines = {order_line("square", "08_12", "beside nodes uniform in a square", summed_square,
                               derivative_sum),
                    order_line("ellipses", "08_13", "beside nodes on ellipses", summed_ellipses,
                               derivative_sum)}};
}

Experiment tolerances() {
  const ErrorBelowTolerance law{1.0, 0.01};
  return {.key = "tolerances",
          .title = "Velocities for a tolerance",
          .x = "tolerance ε",
          .error = "error of the velocity in the 2-norm, relative",
          .lines = {
              tolerance_line("square", "08_14", "at nodes uniform in a square", summed_square,
                             velocity_sum, law),
              tolerance_line("ellipses", "08_15", "at nodes on ellipses", summed_ellipses,
                             velocity_sum, law),
              tolerance_line("crowd", "08_16", "at nodes crowding over eight decades", summed_crowd,
                             velocity_sum, law),
              tolerance_line("forces", "08_34", "beside Stokeslets and rotlets uniform in a square",
                             summed_square, point_force_sum, {1.0, 1e-3})}};
}

Experiment derivative_tolerances() {
  const ErrorBelowTolerance law{1.0, 1e-4};
  return {.key = "derivative_tolerances",
          .title = "Pressure, vorticity and strain for a tolerance",
          .x = "tolerance ε",
          .error = "error of the three beside the nodes in the 2-norm, relative",
          .lines = {tolerance_line("square", "08_17", "beside nodes uniform in a square",
                                   summed_square, derivative_sum, law),
                    tolerance_line("ellipses", "08_18", "beside nodes on ellipses", summed_ellipses,
                                   derivative_sum, law),
                    tolerance_line("crowd", "08_19", "beside crowding nodes", summed_crowd,
                                   derivative_sum, law),
                    tolerance_line("slender", "08_20", "beside one slender body",
                                   summed_slender_body, derivative_sum, law)}};
}

}  // namespace stokesbook::verification::fmm
