// Solves one problem several times. The units of its rows differ more and more.
#include <cmath>

#include "experiments.hpp"
#include "variants.hpp"

namespace stokesbook::verification::lcp {

using namespace study;
using namespace test;

namespace {

constexpr Index row_count = 20;

using Attempt = VectorXd (*)(const LcpProblem& problem);

// Measures the relative error of z, converted back to the units of the first problem.
Measure errors(Attempt attempt) {
  return [=](Size size) {
    const PlantedLcp here = planted("", definite_matrix(row_count, 5), 5, true);
    std::vector<Measurement> measurements;
    for (double decades = 0.0; decades <= 8.0; decades += size == Size::full ? 1.0 : 2.0) {
      const VectorXd scale = random_scale(row_count, 3).array().pow(decades / 6.0);
      const PlantedLcp there = in_other_units(here, scale);
      const VectorXd z = attempt(there.problem).cwiseProduct(scale);
      measurements.push_back({.x = decades, .error = largest(z - here.z) / largest(here.z)});
    }
    return measurements;
  };
}

template <LcpResult (*solver)(const LcpProblem&, const LcpOptions&)>
VectorXd solution(const LcpProblem& problem) {
  return solver(problem, {}).z;
}

VectorXd without_diagonal(const LcpProblem& problem) {
  const auto apply = [&](const VectorXd& z) -> VectorXd { return problem.matrix * z; };
  return matrix_free_barzilai_borwein({apply, problem.offset}).z;
}

// Applies Newton's method, and stops when Fischer's functions are small. This criterion depends on
// the units.
VectorXd without_units(const LcpProblem& problem) {
  VectorXd z = VectorXd::Zero(row_count);
  for (int step = 0; step < 100; ++step) {
    const VectorXd w = problem.offset + problem.matrix * z;
    const VectorXd phi = (z.array().square() + w.array().square()).sqrt() - z.array() - w.array();
    if (largest(phi) < 1e-10) break;
    z = bare_fischer(problem, z, true_radius, 1);
  }
  return z;
}

}  // namespace

Experiment units() {
  return {.key = "units",
          .title = "A problem whose rows have different units",
          .x = "decades between units u",
          .error = "largest error of z, relative to the largest z",
          .axes = Axes::semi_log,
          .lines = {
              {.key = "lemke",
               .label = "Lemke",
               .measure = errors(solution<lemke>),
               .claim = Claim{.id = "11_12",
                              .statement = "The accuracy of Lemke's method does not depend on the "
                                           "units of single rows.",
                              .law = Identity{1e-13},
                              .reason = "the scaled problem is the same up to rounding; its "
                                        "condition is below 50",
                              .api = {"stokesbook::lemke", "stokesbook::lcp_residual"}},
               .control =
                   Control{"Barzilai-Borwein without the diagonal of M", errors(without_diagonal)}},
              {.key = "fischer",
               .label = "Fischer-Newton",
               .measure = errors(solution<fischer_newton>)},
              {.key = "barzilai_borwein",
               .label = "Barzilai-Borwein",
               .measure = errors(solution<barzilai_borwein>),
               .claim = Claim{.id = "11_21",
                              .statement = "With the diagonal of M, the accuracy of "
                                           "Barzilai-Borwein does not depend on the units of "
                                           "single rows.",
                              .law = Identity{5e-9},
                              .reason = "its tolerance of 1e-10, times the condition, which is "
                                        "below 50",
                              .api = {"stokesbook::barzilai_borwein"}},
               .control = Control{"without the diagonal of M", errors(without_diagonal)}},
              {.key = "bare_fischer",
               .label = "Fischer-Newton without scaling",
               .measure = errors(without_units)},
              {.key = "bare_barzilai_borwein",
               .label = "Barzilai-Borwein without the diagonal of M",
               .measure = errors(without_diagonal)}}};
}

}  // namespace stokesbook::verification::lcp
