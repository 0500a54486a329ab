// Measures by how much a gap that contact holds changes over thousands of steps.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "support/exact_gaps.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

constexpr double floor_separation = 0.05;

/// Returns a scene with a heavy ellipse that lies on the floor of a container. A frame is written
/// every `written` steps.
Scene resting_scene(int steps, int written, bool with_contact) {
  Body heavy{.shape = Ellipse{0.5, 0.3}, .position = {0.1, -1.6}, .orientation = 0.1};
  heavy.force = {0.0, -20.0};
  Scene scene = over(in_contact(QuiescentFlow{}, {heavy}, floor_separation), 0.1 * steps, 0.1);
  scene.walls = {{.role = WallRole::outer, .shape = Circle{2.0}}};
  scene.solver.tolerance = 1e-3;
  scene.output.dt_write = 0.1 * written;
  if (!with_contact) scene.contact.reset();
  return scene;
}

// Measures the difference of the gap from the gap of the sixth frame (a quarter of the time), in
// separations.
Measure drift(bool with_contact) {
  return [=](Size size) {
    const int steps = size == Size::full ? 10000 : 400, written = steps / 20;
    const Scene scene = resting_scene(steps, written, with_contact);
    const RecordedRun run = recorded_run(scene, Refusals::recorded);
    std::vector<Measurement> measurements;
    const auto gap = [&](const Frame& frame) {
      return least_exact_gap(placed_shapes(scene, frame), 1.0) / floor_separation;
    };
    for (std::size_t k = 6; k < run.frames.size(); ++k) {
      measurements.push_back(
          {.x = run.frames[k].t / 0.1, .error = std::abs(gap(run.frames[k]) - gap(run.frames[5]))});
    }
    return measurements;
  };
}

}  // namespace

Experiment resting() {
  return {.key = "resting",
          .title = "A heavy ellipse on the floor of a container",
          .x = "steps n",
          .error = "change of its gap since a quarter of the time, in separations",
          .lines = {
              {.key = "drift",
               .label = "with contact",
               .measure = drift(true),
               .claim = Claim{.id = "12_16",
                              .statement = "A body at rest on a wall keeps its gap; it does "
                                           "not drift.",
                              .law = AtMost{1e-5},
                              .reason =
                                  "every step ends at the separation, to a tolerance of 1e-5 of it",
                              .api = {"stokesbook::SuspensionContact"}},
               .control = Control{"contact left out", drift(false)}}}};
}

}  // namespace stokesbook::verification::suspension
