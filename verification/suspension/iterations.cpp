// Counts the GMRES iterations of published scenes by preconditioner and number of nodes: eight
// lobed bodies in shear, and the start of 48 ellipses in vortices.
#include <tuple>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

using MakeScene = Scene (*)();

Scene lobed_bodies() {
  return shipped_scene("lobed_row");
}

Scene ellipses() {
  return test::ellipses_in_vortices();
}

double iterations(MakeScene make_scene, int nodes, PreconditionerKind preconditioner) {
  static test::Once<std::tuple<MakeScene, int, PreconditionerKind>, double> counted;
  return counted({make_scene, nodes, preconditioner}, [&] {
    Scene scene = with_nodes(make_scene(), nodes, nodes);
    scene.solver.preconditioner = preconditioner;
    const SuspensionSolver solver(scene);
    return static_cast<double>(
        solved_at(solver, resolutions_of(solver.discretisation()), 1e-6).gmres.iterations);
  });
}

/// Numbers of nodes, for each size of the study.
struct Nodes {
  std::vector<int> quick, full;
};

const Nodes of_row{{16, 32, 64, 128}, {16, 32, 64, 128, 256, 512}},
    of_vortices{{32, 48, 64}, {32, 48, 64, 96, 128}};

template <class Quantity>
Measure over_nodes_of(const Nodes& counts, const Quantity& quantity) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const int nodes : size == Size::full ? counts.full : counts.quick) {
      measurements.push_back({.x = static_cast<double>(nodes), .error = quantity(nodes)});
    }
    return measurements;
  };
}

Measure row_counts(PreconditionerKind preconditioner) {
  return over_nodes_of(of_row,
                       [=](int nodes) { return iterations(lobed_bodies, nodes, preconditioner); });
}

Measure vortex_counts(PreconditionerKind preconditioner) {
  return over_nodes_of(of_vortices,
                       [=](int nodes) { return iterations(ellipses, nodes, preconditioner); });
}

/// Measures the iterations relative to the iterations without a preconditioner.
Measure vortex_share(PreconditionerKind preconditioner) {
  return over_nodes_of(of_vortices, [=](int nodes) {
    return iterations(ellipses, nodes, preconditioner) /
           iterations(ellipses, nodes, PreconditionerKind::none);
  });
}

constexpr auto none = PreconditionerKind::none, blocks = PreconditionerKind::block_diagonal,
               clusters = PreconditionerKind::clusters;

}  // namespace

Experiment lobed_iterations() {
  return {.key = "lobed",
          .title = "Eight lobed bodies in shear, spacing 1.25: iterations to 1e-6",
          .x = "nodes a body N",
          .error = "iterations",
          .lines = {{.key = "none", .label = "without preconditioner", .measure = row_counts(none)},
                    {.key = "blocks", .label = "block diagonal", .measure = row_counts(blocks)},
                    {.key = "clusters",
                     .label = "clusters",
                     .measure = row_counts(clusters),
                     .claim = Claim{.id = "12_32",
                                    .statement = "Lobed bodies in a row take no more than eleven "
                                                 "iterations, whatever the number of nodes.",
                                    .law = AtMost{11.0},
                                    .reason = "an equation of the second kind, with neighbours "
                                              "solved together; 11.1 is what the published code "
                                              "takes for a step",
                                    .api = {"stokesbook::ClusterPreconditioner"}},
                     .control = Control{"blocks without neighbours", row_counts(blocks)}}}};
}

Experiment vortex_iterations() {
  return {
      .key = "vortex_iterations",
      .title = "48 ellipses in Taylor-Green vortices, at the start: iterations to 1e-6",
      .x = "nodes a body N",
      .error = "iterations, or share of them",
      .lines = {{.key = "none", .label = "without preconditioner", .measure = vortex_counts(none)},
                {.key = "blocks", .label = "block diagonal", .measure = vortex_counts(blocks)},
                {.key = "clusters", .label = "clusters", .measure = vortex_counts(clusters)},
                {.key = "share",
                 .label = "share, block diagonal",
                 .measure = vortex_share(blocks),
                 .claim = Claim{.id = "12_35",
                                .statement = "Own blocks halve the iterations of the 48 ellipses, "
                                             "as published.",
                                .law = Floor{0.5, 1.25},
                                .reason = "published: from 100 to 50 a step, to an unstated "
                                          "residual",
                                .api = {"stokesbook::BlockDiagonalPreconditioner"}},
                 .control = Control{"no blocks in either place", vortex_share(none)}}}};
}

}  // namespace stokesbook::verification::suspension
