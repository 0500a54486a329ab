// Whether automatic node counts meet the tolerance that was asked for.
#include <algorithm>
#include <functional>

#include "experiments.hpp"
#include "scenes.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

// Gaps of 1e-2 and more: these ask for a few hundred nodes.
std::vector<Scene> scenes(int count) {
  std::mt19937_64 random(121);
  std::vector<Scene> found;
  while (static_cast<int>(found.size()) < count) {
    Scene scene = random_scene(random);
    const SuspensionSolver probe(scene);
    const double tolerance = scene.solver.tolerance;
    const std::vector<Gap> gaps =
        find_gaps(probe.initial_configuration(), probe.references(), tolerance);
    if (gaps.front().points.gap < 1e-2 || scene.bodies.size() > 3) continue;
    for (Body& body : scene.bodies) body.n_nodes = stokesbook::automatic_nodes;
    for (Wall& wall : scene.walls) wall.n_nodes = stokesbook::automatic_nodes;
    found.push_back(scene);
  }
  return found;
}

// Chooses nodes for a tolerance.
using Choice = std::function<Resolutions(Scene scene, double tolerance)>;

Resolutions chosen(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  const SuspensionSolver solver(scene);
  return resolutions_of(solver.solve(solver.initial_configuration()).references);
}

// A planted defect: what the shapes ask for, whatever the gaps.
Resolutions for_shapes(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  return resolutions_of(SuspensionSolver(scene).references());
}

Measure worst_errors(const Choice& choice) {
  return [=](Size size) {
    const bool quick = size == Size::quick;
    const std::vector<Scene> some = scenes(quick ? 3 : 12);
    std::vector<Measurement> points;
    for (const double tolerance : {1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
      double worst = 0.0;
      for (Scene scene : some) {
        const Resolutions resolutions = choice(scene, tolerance);
        scene.solver.tolerance = 1e-12;
        const SuspensionSolver tight(scene);
        const Solved answer = solved_at(tight, resolutions, std::max(1e-14, 0.01 * tolerance));
        const Resolutions more = finer(times(1.5, resolutions));
        worst = std::max(worst, error(answer, solved_at(tight, more, 1e-14).completion));
      }
      points.push_back({.x = tolerance, .error = worst});
    }
    return points;
  };
}

}  // namespace

Experiment automatic_nodes() {
  return {.key = "automatic",
          .title = "Automatic nodes: the error achieved",
          .x = "tolerance asked for e",
          .error = "largest error of motions and loads, relative to the largest",
          .lines = {{.key = "chosen",
                     .label = "nodes chosen by the solver",
                     .measure = worst_errors(chosen),
                     .claim = Claim{.id = "12_3",
                                    .statement = "Automatic nodes meet the tolerance, and not by "
                                                 "doing far too much.",
                                    .law = ErrorBelowTolerance{1.0, 1e-4},
                                    .reason = "the estimate is twice the change on finer nodes; "
                                              "counts are multiples of 16",
                                    .api = {"stokesbook::SuspensionSolver"}},
                     .control = Control{"nodes for the shapes alone", worst_errors(for_shapes)}}}};
}

}  // namespace stokesbook::verification::suspension
