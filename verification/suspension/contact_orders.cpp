// Measures the orders of Euler's and Heun's method with contact, for a pair in shear that meets,
// turns and separates.
#include <cmath>
#include <tuple>

#include "experiments.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

constexpr double pair_separation = 0.25;

/// Returns the position of disk 0 relative to disk 1 after 6 units of time.
Complex end(double dt, SteppingMethod method, double kept) {
  static Once<std::tuple<double, SteppingMethod, double>, Complex> ends;
  return ends({dt, method, kept}, [&] {
    std::vector<Body> disks(2, Body{.shape = Circle{0.5}});
    disks[0].position = {-1.5, 0.2};
    Scene scene = over(in_contact(ShearFlow{1.0}, disks, kept), 6.0, dt, method);
    scene.solver.tolerance = 1e-6;
    scene.output.dt_write = 6.0;
    const std::vector<BodyState> bodies = recorded_run(scene).frames.back().bodies;
    return bodies[0].position - bodies[1].position;
  });
}

// A reference with another separation is a planted defect. Steps shorter than those of the
// reference are not measured: contact keeps the gap only between 1 and 1.002 separations, and this
// variation would dominate their error.
Measure errors(SteppingMethod method, double kept_by_reference) {
  return [=](Size size) {
    const bool full = size == Size::full;
    const Complex reference = end(full ? 0.005 : 0.01, SteppingMethod::heun, kept_by_reference);
    std::vector<Measurement> measurements;
    for (double steps = 1.0 / 0.16; steps <= (full ? 101.0 : 26.0); steps *= 2.0) {
      measurements.push_back(
          {.x = steps, .error = std::abs(end(1.0 / steps, method, pair_separation) - reference)});
    }
    return measurements;
  };
}

}  // namespace

Experiment contact_orders() {
  return {.key = "contact_orders",
          .title = "Order in time with contact: two disks that meet in shear, turn and separate",
          .x = "steps a unit of time, (1/Δt)",
          .error = "error of where one ends as seen from the other, radius 1/2",
          .lines = {
              {.key = "euler",
               .label = "Euler",
               .measure = errors(SteppingMethod::euler, pair_separation),
               .claim = Claim{.id = "12_14",
                              .statement = "With contact Euler's method is of order 1.",
                              .law = Algebraic{1.0, 0.15},
                              .reason = "contact is part of the velocity that a step begins with",
                              .api = {"stokesbook::Simulation"}},
               .control = Control{"a reference that keeps 0.3 instead of 0.25",
                                  errors(SteppingMethod::euler, 0.3)}},
              {.key = "heun",
               .label = "Heun",
               .measure = errors(SteppingMethod::heun, pair_separation),
               .claim = Claim{.id = "12_15",
                              .statement = "With contact Heun's method is of order 2.",
                              .law = Algebraic{2.0, 0.2},
                              .window = {.to = 51.0},
                              .reason =
                                  "contact is resolved at both stages; where it begins and ends, a "
                                  "step's velocity has a kink or a jump, which costs an error of "
                                  "the order of its square, and makes the fit uneven",
                              .api = {"stokesbook::Simulation"}},
               .control = Control{"Euler's method instead",
                                  errors(SteppingMethod::euler, pair_separation)}}}};
}

}  // namespace stokesbook::verification::suspension
