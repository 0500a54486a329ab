// Counts the GMRES iterations of a run of eight lobed bodies by the number of nodes, as in the
// published code.
#include <cmath>
#include <tuple>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

/// Returns the states of the row at the written times of a run. The states are the same for all
/// numbers of nodes.
const std::vector<Frame>& states(Size size) {
  static test::Once<Size, std::vector<Frame>> run;
  return run(size, [=] {
    Scene scene = shipped_scene("lobed_row");
    scene.solver.tolerance = 1e-3;
    scene.time->t_final = 2.0;
    if (size == Size::quick) scene.output.dt_write = 0.5;
    return test::recorded_run(scene).frames;
  });
}

/// The residual to which GMRES solves.
enum class Residual {
  given,
  of_spacing  ///< a planted defect: the tolerance decreases with the number of nodes
};

/// Counts the products with the operator in the solves for all these states on given nodes. Each
/// solve starts from zero, as in the published code.
double products(Size size, int nodes, PreconditionerKind preconditioner, Residual residual) {
  static test::Once<std::tuple<Size, int, PreconditionerKind, Residual>, double> counted;
  return counted({size, nodes, preconditioner, residual}, [&] {
    const double tolerance = residual == Residual::given ? 1e-6 : 1e-6 * std::pow(32.0 / nodes, 2);
    double sum = 0.0;
    for (const Frame& frame : states(size)) {
      Scene scene = with_nodes(shipped_scene("lobed_row"), nodes, nodes);
      scene.solver.preconditioner = preconditioner;
      for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        scene.bodies[k].position = frame.bodies[k].position;
        scene.bodies[k].orientation = frame.bodies[k].orientation;
      }
      const SuspensionSolver solver(scene);
      sum += solved_at(solver, resolutions_of(solver.discretisation()), tolerance).gmres.iterations;
    }
    return sum;
  });
}

/// Measures a function of the number of nodes.
template <class Quantity>
Measure over_nodes(const Quantity& quantity) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int nodes = 32; nodes <= (size == Size::full ? 512 : 128); nodes *= 2) {
      measurements.push_back({.x = static_cast<double>(nodes), .error = quantity(size, nodes)});
    }
    return measurements;
  };
}

Measure counts(PreconditionerKind preconditioner) {
  return over_nodes(
      [=](Size size, int nodes) { return products(size, nodes, preconditioner, Residual::given); });
}

/// Measures the relative difference of the count from the count on 32 nodes.
Measure growth(Residual residual) {
  return over_nodes([=](Size size, int nodes) {
    const auto count = [=](int n) {
      return products(size, n, PreconditionerKind::block_diagonal, residual);
    };
    return std::abs(count(nodes) / count(32) - 1.0);
  });
}

}  // namespace

Experiment lobed_run() {
  return left_to_full(
      {.key = "lobed_run",
       .title =
           "Eight lobed bodies in shear, 21 states of a run until t = 2, in the quick study 5: "
           "iterations to 1e-6 in all, without guesses",
       .x = "nodes a body N",
       .error = "iterations, or their relative difference",
       .axes = Axes::no_law,
       .lines = {{.key = "none",
                  .label = "without preconditioner",
                  .measure = counts(PreconditionerKind::none)},
                 {.key = "blocks",
                  .label = "block diagonal, as published",
                  .measure = counts(PreconditionerKind::block_diagonal)},
                 {.key = "clusters",
                  .label = "clusters",
                  .measure = counts(PreconditionerKind::clusters)},
                 {.key = "growth",
                  .label = "block diagonal: relative difference from 32 nodes",
                  .measure = growth(Residual::given),
                  .claim = Claim{.id = "12_53",
                                 .statement = "The iterations of a run of lobed bodies do not "
                                              "grow with the nodes, as published.",
                                 .law = AtMost{0.1},
                                 .reason = "published: 3129 on 16 nodes and 3390 on 512, 8 % "
                                           "more",
                                 .api = {"stokesbook::BlockDiagonalPreconditioner"}},
                  .control = Control{"a residual that falls like the square of the spacing",
                                     growth(Residual::of_spacing)}}}});
}

}  // namespace stokesbook::verification::suspension
