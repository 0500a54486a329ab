// Hard runs: steps that are far too long, crowds in contact, and thousands of steps.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hard_case.hpp"
#include "support/exact_gaps.hpp"
#include "support/known_motions.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

namespace {

/// What is measured of a run that reached its end.
using RunMeasure = std::function<double(const RecordedRun&)>;

Finding run(const Scene& scene, double tolerance, const RunMeasure& error) {
  const RecordedRun recorded = recorded_run(scene, Refusals::recorded);
  Finding finding{.tolerance = tolerance,
                  .iterations = recorded.totals.gmres_iterations,
                  .refusal = recorded.stopped};
  if (recorded.stopped.empty()) finding.error = error(recorded);
  return finding;
}

// By how much the least gap of any written state falls short of the separation, relative to it.
double shortfall(const Scene& scene, const RecordedRun& recorded) {
  const double separation = scene.contact->minimum_separation;
  const double least = least_exact_gap(scene, recorded.frames, 2.0 * separation);
  return std::max(0.0, 1.0 - least / separation);
}

Body pushed(const Shape& shape, Complex position, Complex force) {
  Body result = body(shape, position);
  result.force = force;
  return result;
}

// The step's free end lies beyond a held body, which swept bounding boxes alone see.
Finding tunnelling() {
  Body obstacle = body(Ellipse{1.5, 0.4}, 0.0);
  obstacle.held = true;
  Scene bullet =
      in_contact(QuiescentFlow{}, {pushed(Circle{0.3}, {0.1, 2.0}, {0.0, -100.0}), obstacle}, 0.05);
  bullet.gauge_length = 100.0;
  bullet.solver.tolerance = 1e-3;
  const SuspensionSolver solver(bullet);
  const double speed = std::abs(solver.solve(solver.initial_configuration()).motions[0].velocity);
  bullet = over(bullet, 4.0 / speed, 4.0 / speed);
  return run(bullet, 1e-3, [&](const RecordedRun& recorded) {
    const bool is_through = recorded.frames.back().bodies[0].position.imag() < 0.0;
    return is_through ? 1.0 : shortfall(bullet, recorded);
  });
}

// Disks of a square lattice, all pushed to its centre.
Finding lattice() {
  constexpr int side = 11;
  constexpr double separation = 0.1;
  std::vector<Body> disks;
  for (int k = 0; k < side * side; ++k) {
    const Complex place{k % side - 0.5 * (side - 1), k / side - 0.5 * (side - 1)};
    disks.push_back(pushed(Circle{0.5}, (1.0 + 1.001 * separation) * place, -10.0 * place));
  }
  Scene crowd = over(in_contact(QuiescentFlow{}, disks, separation), 0.1, 0.1);
  crowd.solver.tolerance = 1e-2;
  return run(crowd, 1e-3, [&](const RecordedRun& recorded) {
    const bool is_crowd = recorded.steps.back().contacts >= 200;
    return is_crowd ? shortfall(crowd, recorded) : unknown;
  });
}

// A heavy ellipse on the floor of a container.
Finding thousand_steps_in_contact() {
  Body heavy = pushed(Ellipse{0.5, 0.3}, {0.1, -1.6}, {0.0, -20.0});
  heavy.orientation = 0.1;
  Scene cell = over(in_contact(QuiescentFlow{}, {heavy}, 0.05), 100.0, 0.1);
  cell.walls = {{.role = WallRole::outer, .shape = Circle{2.0}}};
  cell.solver.tolerance = 1e-3;
  cell.output.dt_write = 1.0;
  return run(cell, 1e-3, [&](const RecordedRun& recorded) { return shortfall(cell, recorded); });
}

Finding thousand_steps() {
  Scene alone = scene(ShearFlow{1.0}, {body(Ellipse{1.0, 0.2}, 0.0)}, 1e-10);
  alone = over(alone, 50.0, 0.05, SteppingMethod::rk4);
  alone.output.dt_write = 50.0;
  return run(alone, 1e-5, [](const RecordedRun& recorded) {
    return std::abs(recorded.frames.back().bodies[0].orientation - jeffery_angle(5.0, 50.0));
  });
}

// Two circles that a flow drives together, from 3 to nearly 2 radii.
Scene approach(double t_final, double dt, SteppingMethod method) {
  return over(scene(ExtensionalFlow{-1.0}, {body(Circle{1.0}, -1.5), body(Circle{1.0}, 1.5)}, 1e-8),
              t_final, dt, method);
}

Finding long_first_step() {
  Scene pair = approach(2.0, 2.0, SteppingMethod::dormand_prince54);
  pair.time->tolerance = 1e-6;
  return run(pair, 1e-6, [](const RecordedRun& recorded) {
    const std::vector<BodyState>& bodies = recorded.frames.back().bodies;
    const bool was_too_long = recorded.totals.rejected_steps > 0;
    const double distance = std::abs(bodies[1].position - bodies[0].position);
    return was_too_long ? std::abs(distance - circle_distance(3.0, 2.0)) : unknown;
  });
}

Finding long_fixed_steps() {
  Scene pair = approach(8.0, 2.0, SteppingMethod::euler);
  pair.time->dt_min = 1.5;
  return run(pair, 1e-6, [](const RecordedRun&) { return unknown; });
}

}  // namespace

std::vector<HardCase> motions() {
  return {
      {"09", "a first step twenty times too long, adapted; distance in radii", long_first_step},
      {"09",
       "fixed steps into an overlap that may not be halved enough",
       long_fixed_steps,
       Due::refusal,
       {"overlap", "dt_min"}},
      {"09", "a thousand steps of an ellipse 5:1 in shear; angle", thousand_steps},
      {"10", "a step that would end beyond a held body; shortfall of the separation", tunnelling},
      {"11", "121 disks pressed to a point, 200 contacts; shortfall of the separation", lattice},
      {"11", "a thousand steps at rest in contact; shortfall of the separation",
       thousand_steps_in_contact}};
}

}  // namespace stokesbook::verification::hard_cases
