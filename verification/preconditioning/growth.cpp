// Counts iterations in a tree of groups for packings of up to ten thousand disks, the size of the
// largest packings in the literature, and compares them with the mean for 500 disks.
#include <functional>
#include <vector>

#include "experiments.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;

namespace {

constexpr GmresOptions five_digits{1e-7, 500};

Scene packing(int count, unsigned seed) {
  return test::loaded_packing(count, 0.65, seed);
}

double iterations_of(const LinearSystem& discrete) {
  return static_cast<double>(
      solve(discrete, discrete.system.right_hand_side(), five_digits).iterations);
}

double iterations(const Scene& scene) {
  return iterations_of(
      test::Discretised(test::with_preconditioner(scene, PreconditionerKind::hierarchical))
          .discrete);
}

/// Leaves out of each disk what is left out in small packings.
double iterations_at_one_tolerance(const Scene& scene) {
  test::Discretised start(test::with_preconditioner(scene, PreconditionerKind::none));
  start.discrete.precondition =
      hierarchical_preconditioner(start.discrete.problem, start.configuration, start.discretisation,
                                  placed_schemes(start.configuration, start.discretisation));
  return iterations_of(start.discrete);
}

double mean_of_500() {
  constexpr unsigned packings = 10;
  double sum = 0.0;
  for (unsigned seed = 1; seed <= packings; ++seed) sum += iterations(packing(500, seed));
  return sum / packings;
}

Measure growth(const std::vector<int>& counts,
               const std::function<double(const Scene&)>& iterations_for) {
  return [=](Size) {
    static const double mean = mean_of_500();
    std::vector<Measurement> measurements;
    for (const int count : counts) {
      measurements.push_back(
          {.x = static_cast<double>(count), .error = iterations_for(packing(count, 1)) / mean});
    }
    return measurements;
  };
}

}  // namespace

Experiment growth_of_iterations() {
  return left_to_full(
      {.key = "growth",
       .title = "Iterations for random packings of many disks, over those of 500",
       .x = "number of disks P",
       .error = "iterations to a residual of 1e-7, over the mean of ten packings of 500",
       .lines = {{.key = "tree",
                  .label = "tree of groups",
                  .measure = growth({1000, 3000, 10'000}, iterations),
                  .claim = Claim{.id = "13_15",
                                 .statement = "In a tree of groups, random packings of up to "
                                              "10,000 disks at the area fraction 0.65, with gaps "
                                              "of 0.001 and more, take at most a fifth more "
                                              "iterations than packings of 500.",
                                 .law = AtMost{1.2},
                                 .reason = "the more disks there are, the less is left out of each",
                                 .api = {"stokesbook::hierarchy_settings"}},
                  .control = Control{"as much left out as in small packings",
                                     growth({1000, 2000, 3000}, iterations_at_one_tolerance)}}}});
}

}  // namespace stokesbook::verification::preconditioning
