// Solves for thousands of bodies by the fast multipole method, measures the cost, and compares
// error estimates with errors.
#include <chrono>
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "suspension/nodes/random_fill.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

// Returns ellipses at an area fraction of 35 % in vortices. GMRES stops at 1e-6.
Scene crowd_of(int count) {
  constexpr double a = 1.0, b = 0.5, fraction = 0.35;
  const double side = std::sqrt(count * std::numbers::pi * a * b / fraction);
  Scene scene;
  scene.flow = TaylorGreenFlow{1.0};
  const Fill fill{.body = {.shape = Ellipse{a, b}, .n_nodes = 32},
                  .count = count,
                  .box = std::array{0.0, 0.0, side, side},
                  .clearance = 0.25};
  // The tolerance is loose, so that the solver does not reject the solution on 32 nodes a body.
  scene.solver.tolerance = 0.1;
  scene.solver.gmres_tol = 1e-6;
  return place_fills({scene, {fill}});
}

// Number of the bodies whose motions are compared.
constexpr std::size_t looked_at = 100;

Completion first_of(Completion completion) {
  completion.motions.resize(looked_at);
  completion.loads.resize(looked_at);
  return completion;
}

// Error and estimates for one crowd.
struct JudgedCrowd {
  double error;      // for the first bodies, from a solution on twice the nodes
  double estimate;   // for all bodies, by a correction on finer nodes
  double iteration;  // ten times the residual of GMRES
  double unknowns, iterations, seconds;
};

JudgedCrowd judge_crowd(int count) {
  const Scene scene = crowd_of(count);
  const auto start = std::chrono::steady_clock::now();
  const SuspensionSolver solver(scene);
  const Resolutions resolutions = resolutions_of(solver.discretisation());
  const Solved answer = solved_at(solver, resolutions, *scene.solver.gmres_tol);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const LinearSystem fine =
      solver.linear_system(solver.start(), solver.discretise(refine(resolutions)));
  const Solved twice = solved_at(solver, times(2.0, resolutions), *scene.solver.gmres_tol);
  StokesProblem first = answer.discrete.problem();
  first.components.resize(looked_at);
  return {*relative_change(first, first_of(twice.completion), first_of(answer.completion),
                           answer.scale),
          estimate_error(answer.discrete, answer.density, answer.gmres.residual, fine, answer.scale)
              .error,
          10.0 * answer.gmres.residual,
          2.0 * static_cast<double>(answer.density.size()),
          static_cast<double>(answer.gmres.iterations),
          taken.count()};
}

Measure over_bodies(double JudgedCrowd::*estimate) {
  return [=](Size size) {
    static test::Once<int, JudgedCrowd> judged;
    std::vector<int> counts{125, 250, 500};
    if (size == Size::full) counts = {1000, 3000, 10000};
    std::vector<Measurement> measurements;
    for (const int count : counts) {
      const JudgedCrowd& one = judged(count, [=] { return judge_crowd(count); });
      measurements.push_back({.x = one.*estimate,
                              .error = one.error,
                              .unknowns = one.unknowns,
                              .operations = one.iterations,
                              .seconds = one.seconds});
    }
    return measurements;
  };
}

}  // namespace

Experiment many_bodies() {
  return left_to_full(
      {.key = "many",
       .title = "Ellipses at 35 %, 32 nodes each: the first hundred against twice the nodes",
       .x = "estimate e",
       .error = "difference of the motions of the first hundred, relative to the flow",
       .lines = {{.key = "ellipses",
                  .label = "fast sums",
                  .measure = over_bodies(&JudgedCrowd::estimate),
                  .claim = Claim{.id = "12_8",
                                 .statement = "Motions among thousands of bodies err by no more "
                                              "than their estimate.",
                                 .law = ErrorBelowTolerance{1.0, 1e-2},
                                 .reason = "the estimate is that of the worst of all bodies, "
                                           "the difference that of the worst of a hundred",
                                 .api = {"stokesbook::FastSum", "stokesbook::estimate_error"}},
                  .control = Control{"estimates by the residual of the iteration alone",
                                     over_bodies(&JudgedCrowd::iteration)}}},
       .operation = "iterations"});
}

}  // namespace stokesbook::verification::suspension
