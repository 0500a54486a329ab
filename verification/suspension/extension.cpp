// Runs a crowd of ellipses in extension, and measures its alignment, its gaps with contact, and the
// decay of the bodies' mutual influence with their distance.
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/closed_forms.hpp"
#include "support/exact_gaps.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

constexpr double aligned_from = 0.5;  // earlier, the mean of cos 2 theta may be negative

struct CrowdRun {
  Scene scene;
  RecordedRun run;
};

const CrowdRun& crowd_run(Size size, bool in_contact) {
  static Once<std::pair<Size, bool>, CrowdRun> runs;
  return runs({size, in_contact}, [&] {
    Scene scene = shipped_crowd();
    if (!in_contact) scene.contact.reset();
    scene.solver.tolerance = size == Size::full ? 1e-4 : 1e-2;
    if (size == Size::quick) scene.time->dt = 0.125;
    scene.output.dt_write = 0.25;
    return CrowdRun{scene, recorded_run(scene)};
  });
}

/// Measures a function of a frame at all written times from `from` on.
template <class Quantity>
Measure over_time(bool in_contact, const Quantity& quantity, double from = 0.0) {
  return [=](Size size) {
    const auto& [scene, run] = crowd_run(size, in_contact);
    std::vector<Measurement> measurements;
    for (const Frame& frame : run.frames) {
      if (frame.t < from) continue;
      measurements.push_back({.x = frame.t, .error = quantity(scene, frame)});
    }
    return measurements;
  };
}

Ellipse ellipse_of(const Scene& scene) {
  return std::get<Ellipse>(scene.bodies.front().shape);
}

double order_parameter(const Scene&, const Frame& frame) {
  return frame.rheology.order_parameter;
}

/// Returns the mean of cos 2 theta if each ellipse turned alone: tan theta decays as e^(-2 beta t)
/// (Jeffery).
double order_parameter_alone(const Scene& scene, const Frame& frame) {
  const auto [a, b] = ellipse_of(scene);
  const double beta = (a * a - b * b) / (a * a + b * b);
  double sum = 0.0;
  for (const Body& body : scene.bodies) {
    const double along = std::cos(body.orientation);
    const double across = std::sin(body.orientation) * std::exp(-2.0 * beta * frame.t);
    sum += (along * along - across * across) / (along * along + across * across);
  }
  return sum / static_cast<double>(scene.bodies.size());
}

double least_gap(const Scene& scene, const Frame& frame) {
  return least_exact_gap(placed_shapes(scene, frame), 1.0) /
         shipped_crowd().contact->minimum_separation;
}

Measure lost_in_extension(bool in_contact) {
  return over_time(in_contact, [](const Scene& scene, const Frame& frame) {
    return std::max(0.0, 1.0 - least_gap(scene, frame));
  });
}

/// Returns the motions of the crowd at its start, with all distances multiplied by `spread`.
const std::vector<RigidMotion>& motions_apart(Size size, double spread, double rate) {
  static Once<std::tuple<Size, double, double>, std::vector<RigidMotion>> found;
  return found({size, spread, rate}, [&] {
    Scene scene = shipped_crowd();
    scene.contact.reset();
    scene.solver.tolerance = size == Size::full ? 1e-9 : 1e-7;
    scene.flow = ExtensionalFlow{rate};
    for (Body& body : scene.bodies) body.position *= spread;
    const SuspensionSolver solver(scene);
    return solver.solve(solver.start()).motions;
  });
}

/// Returns the largest difference between the angular velocity of an ellipse in the crowd and that
/// of the same ellipse alone.
///
/// @param  rate  rate of strain; a rate other than 1 is a planted defect
double turned_by_others(Size size, double spread, double rate) {
  const Scene& crowd = shipped_crowd();
  const std::vector<RigidMotion>& motions = motions_apart(size, spread, rate);
  double largest = 0.0;
  for (std::size_t k = 0; k < crowd.bodies.size(); ++k) {
    const double alone =
        free_ellipse_omega(ellipse_of(crowd), crowd.bodies[k].orientation, 0.0, 1.0, 0.0);
    largest = std::max(largest, std::abs(motions[k].omega - alone));
  }
  return largest;
}

Measure differences_from_alone(double least_spread, double rate) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double spread = least_spread; spread <= (size == Size::full ? 64.0 : 32.0);
         spread *= 2.0) {
      measurements.push_back({.x = spread, .error = turned_by_others(size, spread, rate)});
    }
    return measurements;
  };
}

}  // namespace

Experiment extension_order() {
  return {.key = "extension_order",
          .title = "How a crowd of ellipses lines up in extension",
          .x = "strain ė t",
          .error = "mean of cos 2θ",
          .axes = Axes::no_law,
          .lines = {{.key = "crowd",
                     .label = "the crowd",
                     .measure = over_time(true, order_parameter, aligned_from)},
                    {.key = "without",
                     .label = "the crowd without contact",
                     .measure = over_time(false, order_parameter, aligned_from)},
                    {.key = "alone",
                     .label = "the same ellipses, each alone",
                     .measure = over_time(true, order_parameter_alone, aligned_from)}}};
}

Experiment extension_gaps() {
  return {
      .key = "extension_gaps",
      .title = "The least gap of a crowd in extension",
      .x = "strain ė t",
      .error = "in separations",
      .axes = Axes::no_law,
      .lines = {
          {.key = "contact", .label = "with contact", .measure = over_time(true, least_gap)},
          {.key = "lost",
           .label = "shortfall below the separation",
           .measure = lost_in_extension(true),
           .claim = Claim{.id = "12_47",
                          .statement = "In extension a crowd keeps its separation.",
                          .law = AtMost{1e-3},
                          .reason = "each step resolves contact with the mobility of all "
                                    "bodies together",
                          .api = {"stokesbook::SuspensionContact"}},
           .control = Control{"contact left out", lost_in_extension(false)}},
          {.key = "without", .label = "without contact", .measure = over_time(false, least_gap)}}};
}

Experiment extension_apart() {
  return {.key = "extension_apart",
          .title = "How others turn an ellipse of a crowd in extension",
          .x = "distances, in those of the crowd, s",
          .error = "largest difference from the angular velocity alone, over the rate of strain",
          .lines = {{.key = "turned",
                     .label = "36 ellipses",
                     .measure = differences_from_alone(1.0, 1.0),
                     .claim = Claim{.id = "12_48",
                                    .statement = "Ellipses of a crowd in extension turn as each "
                                                 "would alone, but for a difference of order 2 in "
                                                 "size over distance.",
                                    .law = Algebraic{2.0, 0.1},
                                    .window = {.from = 4.0},
                                    .reason = "the others are stresslets; the gradient of their "
                                              "flow falls like s^-2",
                                    .api = {"stokesbook::SuspensionSolver"}},
                     .control = Control{"a rate of strain 1 % too high",
                                        differences_from_alone(8.0, 1.01)}}}};
}

}  // namespace stokesbook::verification::suspension
