// Eight lobed bodies in a row in shear: iterations of a solve, whatever the number of nodes.
#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

/// The bodies of the published run, at the spacing of chapter 06.
Scene lobed_row(int nodes) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.solver.tolerance = 1e-4;
  for (const int arms : {2, 3, 4, 5, 5, 4, 3, 2}) {
    const double along = 1.25 * static_cast<double>(scene.bodies.size());
    scene.bodies.push_back({.shape = Star{0.5, 0.2, arms}, .position = along, .n_nodes = nodes});
  }
  return scene;
}

double iterations(int nodes, PreconditionerKind preconditioner) {
  static test::Once<std::pair<int, PreconditionerKind>, double> counted;
  return counted({nodes, preconditioner}, [&] {
    Scene scene = lobed_row(nodes);
    scene.solver.preconditioner = preconditioner;
    const SuspensionSolver solver(scene);
    return static_cast<double>(
        solved_at(solver, resolutions_of(solver.references()), 1e-6).gmres.iterations);
  });
}

Measure over_nodes(PreconditionerKind preconditioner) {
  return [=](Size size) {
    std::vector<int> counts{16, 32, 64, 128};
    if (size == Size::full) counts.insert(counts.end(), {256, 512});
    std::vector<Measurement> measurements;
    for (const int nodes : counts) {
      measurements.push_back(
          {.x = static_cast<double>(nodes), .error = iterations(nodes, preconditioner)});
    }
    return measurements;
  };
}

}  // namespace

Experiment lobed_iterations() {
  return {.key = "lobed",
          .title = "Eight lobed bodies in shear, spacing 1.25: iterations to 1e-6",
          .x = "nodes a body N",
          .error = "iterations",
          .lines = {{.key = "none",
                     .label = "without preconditioner",
                     .measure = over_nodes(PreconditionerKind::none)},
                    {.key = "blocks",
                     .label = "block diagonal",
                     .measure = over_nodes(PreconditionerKind::block_diagonal)},
                    {.key = "clusters",
                     .label = "clusters",
                     .measure = over_nodes(PreconditionerKind::clusters),
                     .claim = Claim{.id = "12_32",
                                    .statement = "Lobed bodies in a row take no more than eleven "
                                                 "iterations, whatever the number of nodes.",
                                    .law = Identity{11.0},
                                    .reason = "an equation of the second kind, with neighbours "
                                              "solved together; 11.1 is what the published code "
                                              "takes for a step",
                                    .api = {"stokesbook::ClusterPreconditioner"}},
                     .control = Control{"blocks that do not know their neighbours",
                                        over_nodes(PreconditionerKind::block_diagonal)}}}};
}

}  // namespace stokesbook::verification::suspension
