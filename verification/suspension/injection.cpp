// Runs bodies that a flow carries out through a ring of held disks and, after a reversal, back.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

/// Returns the run of the injection scene of chapter 12 with another time of reversal. Eight disks
/// are held, and eight bodies are free.
const RecordedRun& run(Size size, double dt, SteppingMethod method) {
  static Once<std::tuple<Size, double, SteppingMethod>, RecordedRun> runs;
  return runs({size, dt, method}, [&] {
    const double reversal = size == Size::full ? 2.5 : 1.25;
    Scene scene = shipped_scene("injection");
    scene.solver.tolerance = 1e-4;
    scene.time->dt = dt;
    scene.time->method = method;
    scene.time->t_final = 2.0 * reversal;
    scene.reverse_at = {reversal};
    scene.output.dt_write = reversal;
    return recorded_run(scene);
  });
}

double largest_distance(const Frame& a, const Frame& b) {
  double distance = 0.0;
  for (std::size_t k = 0; k < a.bodies.size(); ++k) {
    distance = std::max(distance, std::abs(a.bodies[k].position - b.bodies[k].position));
  }
  return distance;
}

/// Measures the largest distance of a body between two of the three frames (start, turn, end).
Measure distances(SteppingMethod method, std::size_t from, std::size_t to) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double steps = 4.0; steps <= (size == Size::full ? 32.0 : 16.0); steps *= 2.0) {
      const RecordedRun& found = run(size, 1.0 / steps, method);
      measurements.push_back(
          {.x = steps, .error = largest_distance(found.frames[from], found.frames[to])});
    }
    return measurements;
  };
}

}  // namespace

Experiment injection() {
  return {
      .key = "injection",
      .title = "Injection through a ring of held disks, reversed",
      .x = "steps a unit of time, (1/Δt)",
      .error = "largest distance of a body",
      .lines = {
          {.key = "heun",
           .label = "Heun: of the end from the start",
           .measure = distances(SteppingMethod::heun, 0, 2),
           .claim = Claim{.id = "12_33",
                          .statement = "Bodies that were carried out through the ring come "
                                       "back, with an error of order 3.",
                          .law = Algebraic{3.0, 0.3},
                          .reason = "Stokes flow returns along its path; errors of a method "
                                    "of order 2 cancel to the next order on the way back",
                          .api = {"stokesbook::Simulation", "stokesbook::RadialWall"}},
           .control = Control{"Euler's method instead", distances(SteppingMethod::euler, 0, 2)}},
          {.key = "euler",
           .label = "Euler: of the end from the start",
           .measure = distances(SteppingMethod::euler, 0, 2)},
          {.key = "out",
           .label = "Heun: of the turn from the start",
           .measure = distances(SteppingMethod::heun, 0, 1)}}};
}

}  // namespace stokesbook::verification::suspension
