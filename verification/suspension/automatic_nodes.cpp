// Tests whether automatic node numbers meet the solver's tolerance: compares solutions at several
// tolerances with solutions on finer nodes.
#include <algorithm>
#include <functional>

#include "experiments.hpp"
#include "scenes.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

// Tightest tolerance of the experiment.
constexpr double tightest_tolerance = 1e-11;

// Returns whether the solver meets the tightest tolerance in spite of rounding errors.
bool is_solvable(Scene scene) {
  scene.solver.tolerance = tightest_tolerance;
  const SuspensionSolver solver(scene);
  try {
    solver.solve(solver.start());
    return true;
  } catch (const SolverError&) {
    return false;
  }
}

// Generates random scenes with gaps of at least 1e-2, for which the solver accepts all tolerances.
std::vector<Scene> scenes(int count) {
  std::mt19937_64 random(121);
  std::vector<Scene> found;
  while (static_cast<int>(found.size()) < count) {
    Scene scene = random_scene(random);
    const SuspensionSolver probe(scene);
    const double tolerance = scene.solver.tolerance;
    const std::vector<Gap> gaps =
        find_gaps(probe.start().configuration, probe.discretisation(), tolerance);
    if (gaps.front().points.gap < 1e-2 || scene.bodies.size() > 3) continue;
    scene = with_nodes(std::move(scene), automatic_nodes, automatic_nodes);
    if (is_solvable(scene)) found.push_back(scene);
  }
  return found;
}

// Node numbers, and the residual at which GMRES stops.
struct Effort {
  Resolutions resolutions;
  double gmres_tolerance;
};

// Chooses the effort for a tolerance.
using Choice = std::function<Effort(Scene scene, double tolerance)>;

Effort chosen(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  const SuspensionSolver solver(scene);
  const Solution solution = solver.solve(solver.start());
  return {resolutions_of(solution.discretisation), solution.gmres.residual};
}

// Chooses the nodes that the shapes require, without more nodes at gaps: a planted defect.
Effort for_shapes(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  return {resolutions_of(SuspensionSolver(scene).discretisation()), 0.01 * tolerance};
}

Measure worst_errors(const Choice& choice) {
  return [=](Size size) {
    const bool quick = size == Size::quick;
    const std::vector<Scene> some = scenes(quick ? 3 : 12);
    std::vector<Measurement> points;
    for (const double tolerance : {tightest_tolerance, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
      double worst = 0.0;
      for (Scene scene : some) {
        const Effort effort = choice(scene, tolerance);
        scene.solver.tolerance = 1e-12;
        const SuspensionSolver tight(scene);
        const Solved answer =
            solved_at(tight, effort.resolutions, std::max(1e-12, effort.gmres_tolerance));
        const Resolutions more = refine(times(1.5, effort.resolutions));
        worst = std::max(worst, error(answer, solved_at(tight, more, 1e-12).completion));
      }
      points.push_back({.x = tolerance, .error = worst});
    }
    return points;
  };
}

}  // namespace

Experiment errors_on_automatic_nodes() {
  return {.key = "automatic",
          .title = "Automatic nodes: the error achieved",
          .x = "tolerance ε",
          .error = "largest error of motions and loads, relative to the largest",
          .lines = {{.key = "chosen",
                     .label = "nodes chosen by the solver",
                     .measure = worst_errors(chosen),
                     .claim = Claim{.id = "12_3",
                                    .statement = "The error on automatic nodes is below the "
                                                 "tolerance, by at most four digits.",
                                    .law = ErrorBelowTolerance{1.0, 1e-4},
                                    .reason = "the estimate is twice the change on finer nodes; "
                                              "counts are multiples of 16",
                                    .api = {"stokesbook::SuspensionSolver"}},
                     .control = Control{"nodes for the shapes alone", worst_errors(for_shapes)}}}};
}

}  // namespace stokesbook::verification::suspension
