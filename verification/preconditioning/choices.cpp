// Compares the CPU time of short runs with the preconditioner that the plan chooses, and with the
// fastest of all preconditioners, on scenes of all kinds.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"
#include "suspension/motion/simulation.hpp"
#include "suspension/nodes/random_fill.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;

namespace {

using Kind = PreconditionerKind;

constexpr double never = std::numeric_limits<double>::infinity();

/// Returns the CPU seconds of a run: the least of several runs if they are short. A run ends
/// without a result when it has taken longer than the limit, or a solve has failed.
double seconds_of(const Scene& scene, double limit) {
  constexpr double enough = 0.5;
  const SuspensionSolver solver(scene);
  double least = never, sum = 0.0;
  while (sum < enough) {
    const std::clock_t start = std::clock();
    const auto taken = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
    Observer observer;
    observer.step = [&](const StepInfo&) {
      if (taken() > limit) throw std::runtime_error("longer than the limit");
    };
    try {
      Simulation(solver, observer).run();
    } catch (const std::runtime_error&) {
      return least;
    }
    least = std::min(least, taken());
    sum += taken();
  }
  return least;
}

/// Returns the CPU time with the plan's choices, over the least of all preconditioners.
double over_the_best(const Scene& scene) {
  const double with_choices = seconds_of(scene, never);
  double least = with_choices;
  const auto try_others = [&](const std::vector<Kind>& kinds) {
    for (const Kind kind : kinds) {
      least = std::min(least, seconds_of(test::with_preconditioner(scene, kind), least));
    }
  };
  try_others({Kind::hierarchical, Kind::none, Kind::block_diagonal});
  // The set-up of the others takes minutes if there are many bodies.
  if (scene.bodies.size() <= 100) try_others({Kind::clusters});
  if (scene.bodies.size() <= 30) try_others({Kind::direct});
  return with_choices / least;
}

Scene with_tolerance(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  return scene;
}

/// Holds every third body.
Scene with_pores(Scene scene) {
  for (std::size_t k = 0; k < scene.bodies.size(); k += 3) scene.bodies[k].held = true;
  return scene;
}

/// Returns disks between two circles, the outer of which turns.
Scene between_circles(int count) {
  constexpr double fraction = 0.4, inner_radius = 0.5;
  const double outer = std::sqrt(count / (fraction * (1.0 - inner_radius * inner_radius)));
  SceneFile file;
  file.scene.seed = 5;
  file.scene.solver.tolerance = 1e-5;
  file.scene.walls = {
      {.role = WallRole::outer, .shape = Circle{outer}, .motion = RotatingWall{1.0 / outer}},
      {.role = WallRole::inner, .shape = Circle{inner_radius * outer}}};
  file.fills = {{.body = {.shape = Circle{1.0}}, .count = count, .clearance = 0.02}};
  return place_fills(file);
}

/// Returns bodies of one area, kept apart by contact, in a circle that turns.
Scene in_turning_circle(const Shape& shape, int count) {
  constexpr double gap = 0.01;
  const double radius = 0.365 * std::sqrt(static_cast<double>(count));
  SceneFile file;
  file.scene.seed = 3;
  file.scene.solver.tolerance = 1e-3;
  file.scene.walls = {
      {.role = WallRole::outer, .shape = Circle{radius}, .motion = RotatingWall{1.0}}};
  file.fills = {{.body = {.shape = shape}, .count = count, .clearance = gap}};
  return test::with_contact(place_fills(file), gap);
}

/// Returns a hexagon with at least this number of disks.
Scene crystal(int count) {
  int rings = 1;
  while (1 + 3 * rings * (rings + 1) < count) ++rings;
  return with_tolerance(test::disk_hexagon(rings, 0.01), 1e-5);
}

/// Returns a crowd of ellipses that an extensional flow presses together: no pair is in contact at
/// first.
Scene crowd_in_extension(int count) {
  const double half = 0.39 * std::sqrt(static_cast<double>(count));
  SceneFile file;
  file.scene.seed = 1;
  file.scene.flow = ExtensionalFlow{1.0};
  file.scene.solver.tolerance = 1e-3;
  file.fills = {{.body = {.shape = Ellipse{0.5, 0.25}},
                 .count = count,
                 .box = {{-half, -1.6 * half, half, 1.6 * half}},
                 .clearance = 0.05}};
  return test::with_contact(place_fills(file), 0.05);
}

/// Measures scenes of one kind with various numbers of bodies.
Line family(const std::string& key, const std::string& label,
            const std::function<Scene(int)>& scene, const std::vector<int>& counts,
            double dt = 0.02, int steps = 3) {
  return {.key = key, .label = label, .measure = [=](Size) {
            std::vector<Measurement> measurements;
            for (const int count : counts) {
              measurements.push_back(
                  {.x = static_cast<double>(count),
                   .error = over_the_best(test::over(scene(count), steps * dt, dt))});
            }
            return measurements;
          }};
}

Experiment with_lines(std::string key, std::string scenes, std::vector<Line> lines) {
  return left_to_full({.key = std::move(key),
                       .title = "Time of " + std::move(scenes) +
                                " with the plan's preconditioner, over the least time of all",
                       .x = "number of bodies P",
                       .error = "CPU seconds of a run, over those with the fastest preconditioner",
                       .axes = Axes::nominal,
                       .lines = std::move(lines)});
}

}  // namespace

Experiment choices() {
  using namespace test;
  return with_lines(
      "choices", "bodies in a plane",
      {family("dense", "disks under loads, area fraction 0.65",
              [](int count) { return loaded_packing(count, 0.65); }, {10, 30, 100, 300}),
       family("medium", "disks under loads, 0.35",
              [](int count) { return loaded_packing(count, 0.35); }, {10, 30, 100, 300, 1000}),
       family("dilute", "disks under loads, 0.05",
              [](int count) { return loaded_packing(count, 0.05); }, {10, 30, 100, 300, 1000}),
       family("coarse", "disks under loads, 0.5, tolerance 1e-3",
              [](int count) { return with_tolerance(loaded_packing(count, 0.5), 1e-3); },
              {10, 30, 100, 300}),
       family("fine", "disks under loads, 0.2, tolerance 1e-8",
              [](int count) { return with_tolerance(loaded_packing(count, 0.2), 1e-8); },
              {10, 30, 100, 300}),
       family("fixed", "line of disks, gap 0.1, 64 nodes each",
              [](int count) { return with_nodes(loaded_line(count, 0.1), 64); },
              {10, 30, 100, 300}),
       family("ellipses", "ellipses 3:1 under loads, 0.5",
              [](int count) { return loaded_ellipses(count, 0.5); }, {10, 30, 100, 300}),
       family("few_ellipses", "ellipses 3:1 under loads, 0.2",
              [](int count) { return loaded_ellipses(count, 0.2); }, {10, 30, 100, 300}),
       family("vortices", "ellipses in vortices", [](int) { return ellipses_in_vortices(); }, {48}),
       family("line", "line of disks, gap 0.01", [](int count) { return loaded_line(count, 0.01); },
              {10, 30, 100, 300}),
       family("tight_line", "line of disks, gap 0.001",
              [](int count) { return loaded_line(count, 0.001); }, {10, 30, 100}),
       family("crystal", "hexagon of disks, gap 0.01", crystal, {7, 19, 37, 61})});
}

Experiment choices_in_contact() {
  using namespace test;
  return with_lines(
      "choices_in_contact", "bodies between walls and in contact",
      {family("container", "disks that settle in a container, area fraction 0.55",
              [](int count) { return settling_in_container(1.0, count, 0.55, 0.005); },
              {10, 30, 100, 200, 300}),
       family("coarse_container", "disks that settle in a container, 0.55, tolerance 1e-3",
              [](int count) {
                return with_tolerance(settling_in_container(1.0, count, 0.55, 0.005), 1e-3);
              },
              {30, 100}),
       family("wide_container", "disks that settle in a container, 0.3, 48 nodes each",
              [](int count) { return with_nodes(settling_in_container(1.0, count, 0.3, 0.1), 48); },
              {10, 30, 100, 300}),
       family("ellipses_in_container", "ellipses 3:1 that settle in a container, 0.4",
              [](int count) { return settling_in_container(3.0, count, 0.4, 0.02); },
              {10, 30, 100, 300}),
       family("settling_contact", "disks that settle with contact, 0.55",
              [](int count) {
                return test::with_contact(settling_in_container(1.0, count, 0.55, 0.01), 0.01);
              },
              {10, 30, 100, 300}),
       family("contact", "disks in shear with contact, 0.6",
              [](int count) {
                return test::with_contact(test::sheared(loaded_packing(count, 0.6)), 1e-3);
              },
              {10, 30, 100, 300}),
       family("contact_of_ellipses", "ellipses 3:1 in shear with contact, 0.4",
              [](int count) {
                return test::with_contact(test::sheared(loaded_ellipses(count, 0.4)), 1e-3);
              },
              {10, 30, 100}),
       family(
           "turning_disks", "disks with contact in a turning circle, 0.27, tolerance 1e-3",
           [](int count) { return in_turning_circle(Circle{0.19}, count); }, {10, 30, 100, 300},
           0.1),
       family(
           "turning_ellipses", "ellipses 5:2 with contact in a turning circle, 0.27, 1e-3",
           [](int count) {
             return in_turning_circle(Ellipse{0.3, 0.12}, count);
           },
           {10, 30, 100, 300}, 0.1),
       family("crowd", "ellipses 2:1 with contact in extension, 75 steps", crowd_in_extension,
              {10, 30, 60}, 0.02, 75),
       family("annulus", "disks between two circles, 0.4", between_circles, {10, 30, 100, 300}),
       family("pores", "disks in shear, 0.5, a third of them held",
              [](int count) { return with_pores(test::sheared(loaded_packing(count, 0.5))); },
              {10, 30, 100})});
}

}  // namespace stokesbook::verification::preconditioning
