// Compares error estimates of fields with their errors, on given nodes.
#include <algorithm>

#include "experiments.hpp"
#include "scenes.hpp"
#include "suspension/solver/fields.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

// Returns two scenes: a star, a superellipse and an ellipse in extension, and two disks that sink
// in a container.
std::vector<Scene> scenes_with_fields() {
  using enum FieldQuantity;
  std::vector<Scene> scenes{shipped_scene("three_shapes"), shipped_scene("sedimentation")};
  for (Scene& scene : scenes) {
    scene.solver.tolerance = 1e-2;
    scene.output.fields = FieldSettings{
        {-4.0, -4.0, 4.0, 4.0}, 40, {velocity, pressure, vorticity, shear_stress, dissipation}};
  }
  return scenes;
}

enum class Estimate { of_each_quantity, of_velocities };

Measure errors_over(Estimate estimate) {
  return [=](Size size) {
    std::vector<Measurement> points;
    for (const Scene& scene : scenes_with_fields()) {
      Scene closer = with_nodes(scene, automatic_nodes, automatic_nodes);
      closer.solver.tolerance = 1e-9;
      const SuspensionSolver reference(closer);
      const Instant start = reference.start();
      const Field right = estimated_field(reference, reference.solve(start)).field;
      for (int nodes = 64; nodes <= 160; nodes += size == Size::full ? 8 : 32) {
        const SuspensionSolver solver(with_nodes(scene, nodes, 2 * nodes));
        const Solution solution = solver.solve(start);
        const EstimatedField found = estimated_field(solver, solution);
        for (const auto& [quantity, error] : field_differences(found.field, right)) {
          points.push_back({.x = estimate == Estimate::of_velocities ? solution.error_estimate
                                                                     : found.errors.at(quantity),
                            .error = error});
        }
      }
    }
    std::ranges::sort(points, {}, &Measurement::x);
    return points;
  };
}

}  // namespace

Experiment field_errors() {
  return {
      .key = "field_errors",
      .title = "Errors of fields and their estimates",
      .x = "estimate e",
      .error = "error of a quantity on the grid, relative to its largest value",
      .lines = {{.key = "fields",
                 .label = "velocity, pressure, vorticity, shear stress, dissipation",
                 .measure = errors_over(Estimate::of_each_quantity),
                 .claim = Claim{.id = "12_60",
                                .statement = "Errors of fields are at most twice their estimates, "
                                             "and not far less.",
                                .law = ErrorBelowTolerance{2.0, 0.02},
                                .reason = "twice the change by a quarter more nodes, which "
                                          "takes most of the error away",
                                .api = {"stokesbook::estimated_field"}},
                 .control = Control{"the estimate of the velocities of bodies",
                                    errors_over(Estimate::of_velocities)}}}};
}

}  // namespace stokesbook::verification::suspension
