// Solves packings of up to ten thousand disks, the size of the largest packings in the literature:
// compares the iterations in a tree of groups with the mean for 500 disks, and estimates errors.
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

#include "experiments.hpp"
#include "support/once.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;

namespace {

/// Holds the cost of solving a packing, and the error estimate of the solution.
struct PackingSolve {
  double iterations;
  double matvecs;
  double cpu_seconds;
  double error_estimate;
};

Scene packing(int count, unsigned seed) {
  return test::loaded_packing(count, 0.65, seed);
}

PackingSolve solve_packing(const Scene& scene) {
  const std::clock_t start = std::clock();
  const SuspensionSolver solver(scene);
  const Solution solution = solver.solve(solver.start());
  return {static_cast<double>(solution.cost.gmres_iterations),
          static_cast<double>(solution.cost.matvecs),
          static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, solution.error_estimate};
}

const PackingSolve& solved(int count, unsigned seed = 1) {
  static test::Once<std::pair<int, unsigned>, PackingSolve> solves;
  return solves({count, seed}, [=] {
    return solve_packing(
        test::with_preconditioner(packing(count, seed), PreconditionerKind::hierarchical));
  });
}

/// Leaves out of each disk what is left out in small packings.
double iterations_at_one_tolerance(int count) {
  const Scene scene = test::with_preconditioner(packing(count, 1), PreconditionerKind::none);
  const GmresOptions options{make_plan(scene).gmres_tolerance, scene.solver.gmres_max_iterations};
  test::Discretised start(scene);
  start.discrete.precondition = hierarchical_preconditioner(
      start.discrete.problem(), start.configuration, start.discretisation,
      placed_schemes(start.configuration, start.discretisation));
  return solve(start.discrete, start.discrete.system.right_hand_side(), options).iterations;
}

double mean_of_500() {
  constexpr unsigned packings = 10;
  double sum = 0.0;
  for (unsigned seed = 1; seed <= packings; ++seed) sum += solved(500, seed).iterations;
  return sum / packings;
}

Measure growth(const std::vector<int>& counts, const std::function<double(int)>& iterations_of) {
  return [=](Size) {
    static const double mean = mean_of_500();
    std::vector<Measurement> measurements;
    for (const int count : counts) {
      measurements.push_back(
          {.x = static_cast<double>(count), .error = iterations_of(count) / mean});
    }
    return measurements;
  };
}

Measurement judged(int count, const PackingSolve& solve) {
  return {.x = static_cast<double>(count),
          .error = solve.error_estimate,
          .operations = solve.matvecs,
          .seconds = solve.cpu_seconds};
}

std::vector<Measurement> estimates(Size) {
  std::vector<Measurement> measurements;
  for (const int count : {500, 1000, 3000, 10'000}) {
    measurements.push_back(judged(count, solved(count)));
  }
  return measurements;
}

std::vector<Measurement> estimates_at_two_digits(Size) {
  std::vector<Measurement> measurements;
  for (const int count : {100, 200, 500}) {
    Scene scene = packing(count, 1);
    scene.solver.tolerance = 1e-2;
    measurements.push_back(judged(count, solve_packing(scene)));
  }
  return measurements;
}

}  // namespace

Experiment growth_of_iterations() {
  return left_to_full(
      {.key = "growth",
       .title = "Iterations for random packings of many disks, over those of 500",
       .x = "number of disks P",
       .error = "iterations, over the mean of ten packings of 500",
       .lines = {{.key = "tree",
                  .label = "tree of groups",
                  .measure = growth({1000, 3000, 10'000},
                                    [](int count) { return solved(count).iterations; }),
                  .claim = Claim{.id = "13_15",
                                 .statement = "In a tree of groups, random packings of up to "
                                              "10,000 disks at the area fraction 0.65, with gaps "
                                              "of 0.001 and more, take at most a fifth more "
                                              "iterations than packings of 500.",
                                 .law = AtMost{1.2},
                                 .reason = "the more disks there are, the less is left out",
                                 .api = {"stokesbook::hierarchy_settings"}},
                  .control = Control{"as much left out as in small packings",
                                     growth({1000, 2000, 3000}, iterations_at_one_tolerance)}}}});
}

Experiment judged_packings() {
  return left_to_full(
      {.key = "judged_packings",
       .title = "Error estimates for random packings of many disks",
       .x = "number of disks P",
       .error = "error estimate of the velocities, relative to the largest",
       .lines = {{.key = "tree",
                  .label = "tree of groups",
                  .measure = estimates,
                  .claim =
                      Claim{.id = "13_16",
                            .statement = "Velocities in random packings of up to 10,000 disks at "
                                         "the area fraction 0.65, with gaps of 0.001 and more, "
                                         "have five digits by their error estimate.",
                            .law = AtMost{1e-5},
                            .reason = "the tolerance of the scenes is 1e-5",
                            .api = {"stokesbook::SuspensionSolver", "stokesbook::estimate_error"}},
                  .control = Control{"the tolerance 1e-2", estimates_at_two_digits}}},
       .work_precision = true,
       .operation = "matrix-vector products"});
}

}  // namespace stokesbook::verification::preconditioning
