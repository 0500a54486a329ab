// Measures the error of one Newton step from a guess near the solution.
#include <algorithm>

#include "experiments.hpp"
#include "lcp/scaled_problem.hpp"
#include "variants.hpp"

namespace stokesbook::verification::lcp {

using namespace study;
using namespace test;

namespace {

constexpr Index pair_count = 20;

// Returns a problem in which half of the pairs are in contact (z > 0). The other pairs are open
// (w > 0); if `degenerate`, half of the other pairs have z = w = 0 instead.
PlantedLcp pairs(bool degenerate) {
  const MatrixXd matrix = definite_matrix(pair_count, 8);
  VectorXd z = VectorXd::Zero(pair_count), w = z;
  for (Index i = 0; i < pair_count; ++i) {
    const double value = 0.3 + 0.07 * static_cast<double>(i);
    if (i % 2 == 0) {
      z[i] = value;
    } else if (!degenerate || i % 4 == 1) {
      w[i] = value;
    }
  }
  return {"", {matrix, w - matrix * z}, z, true};
}

using Step = VectorXd (*)(const LcpProblem& problem, const VectorXd& guess);

VectorXd fischer_step(const LcpProblem& problem, const VectorXd& guess) {
  return fischer_newton(problem, {.tolerance = 0.0, .max_iterations = 1, .guess = guess}).z;
}

VectorXd misprinted_step(const LcpProblem& problem, const VectorXd& guess) {
  return bare_fischer(problem, guess, published_radius, 1);
}

VectorXd minimum_map_step(const LcpProblem& problem, const VectorXd& guess) {
  return minimum_map_newton(problem, {.tolerance = 0.0, .max_iterations = 1, .guess = guess}).z;
}

Measure after_a_step(Step step, bool degenerate) {
  return [=](Size size) {
    const PlantedLcp lcp = pairs(degenerate);
    const VectorXd direction = normal_matrix(pair_count, 1, 11).cwiseAbs();
    std::vector<Measurement> measurements;
    const double ratio = size == Size::full ? 2.0 : 4.0;
    for (double d = 0.1; d > 1e-6; d /= ratio) {
      const VectorXd guess = lcp.z + d / largest(direction) * direction;
      measurements.push_back({.x = d, .error = largest(step(lcp.problem, guess) - lcp.z)});
    }
    std::ranges::reverse(measurements);
    return measurements;
  };
}

Claim quadratic(const std::string& id, const std::string& kind) {
  return {.id = id,
          .statement = "A step of Fischer-Newton squares the error, " + kind + ".",
          .law = Algebraic{-2.0, 0.15},
          .window = {.to = 0.01, .floor = 1e-14},
          .reason =
              "the Jacobian has a Lipschitz constant along rays from the solution, also "
              "where both entries of a pair vanish: Fischer's function is homogeneous",
          .api = {"stokesbook::fischer_newton"}};
}

}  // namespace

Experiment newton_steps() {
  return {
      .key = "newton_steps",
      .title = "One step from a guess near the solution",
      .x = "distance of the guess d",
      .error = "largest error of z after the step",
      .lines = {
          {.key = "fischer",
           .label = "Fischer-Newton, no degenerate pairs",
           .measure = after_a_step(fischer_step, false),
           .claim = quadratic("11_7", "where one of each pair is positive"),
           .control = Control{"sqrt(z + w) in the Jacobian, as printed",
                              after_a_step(misprinted_step, false)}},
          {.key = "degenerate",
           .label = "Fischer-Newton, a quarter degenerate",
           .measure = after_a_step(fischer_step, true),
           .claim = quadratic("11_8", "with a quarter of the pairs degenerate"),
           .control = Control{"sqrt(z + w) in the Jacobian, as printed",
                              after_a_step(misprinted_step, true)}},
          {.key = "misprint",
           .label = "with the misprinted Jacobian",
           .measure = after_a_step(misprinted_step, false)},
          {.key = "minimum_map",
           .label = "minimum-map Newton",
           .measure = after_a_step(minimum_map_step, false),
           .claim = Claim{.id = "11_9",
                          .statement = "Near the solution a step of the minimum map is "
                                       "exact.",
                          .law = Identity{1e-13},
                          .window = {.to = 0.01},
                          .reason = "the set where w < z is that of the solution, and the "
                                    "rest is a linear system of condition below 50",
                          .api = {"stokesbook::minimum_map_newton"}},
           .control = Control{"contacts wherever z > 0", after_a_step(step_by_sign_of_z, false)}}}};
}

}  // namespace stokesbook::verification::lcp
