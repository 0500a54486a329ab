// Runs all solvers on twenty problems, and measures residuals and costs.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "lcp/scaled_problem.hpp"
#include "support/once.hpp"
#include "variants.hpp"

namespace stokesbook::verification::lcp {

using namespace study;
using namespace test;

namespace {

// Holds a solver, and its cost in products of an m x m matrix and a vector (2 m^2 operations each).
// A factorisation costs m/3 products.
struct Method {
  std::string key, label;
  LcpSolver solve;
  double (*products)(double iterations, double m);
};

const std::vector<Method>& methods() {
  static const std::vector<Method> all{
      {"lemke", "Lemke", lemke, [](double k, double m) { return k + m / 3.0; }},
      {"fischer", "Fischer-Newton", fischer_newton,
       [](double k, double m) { return k * (m / 3.0 + 2.0); }},
      {"minimum_map", "minimum-map Newton", minimum_map_newton,
       [](double k, double m) { return k * (m / 3.0 + 1.0); }},
      {"gauss_seidel", "projected Gauss-Seidel", projected_gauss_seidel,
       [](double k, double) { return 2.0 * k; }},
      {"barzilai_borwein", "Barzilai-Borwein", barzilai_borwein,
       [](double k, double) { return k; }},
      {"all_sets", "all sets, for up to 12 rows",
       [](const LcpProblem& problem, const LcpOptions&) { return try_all_sets(problem); },
       [](double k, double m) { return k * (m / 3.0 + 1.0); }}};
  return all;
}

// Residuals are raised to at least this number, because the figure cannot show 0.
constexpr double invisible = 1e-17;

struct Run {
  double residual = 0.0;
  double products = 0.0;
  bool solved = false;
};

std::vector<Run> run_suite(const Method& method) {
  std::vector<Run> runs;
  for (const PlantedLcp& lcp : test::suite()) {
    const LcpResult result = method.solve(lcp.problem, {});
    const auto m = static_cast<double>(lcp.z.size());
    runs.push_back({result.residual, method.products(result.iterations, m), solved(result)});
  }
  return runs;
}

// Runs the suite once for each method, and returns the same results for the figures of residuals
// and of costs.
const std::vector<Run>& runs_of(const Method& method) {
  static Once<std::string, std::vector<Run>> runs;
  return runs(method.key, [&] { return run_suite(method); });
}

Measure residuals(const Method& method) {
  return [&method](Size) {
    std::vector<Measurement> measurements;
    for (const Run& run : runs_of(method)) {
      measurements.push_back({.x = static_cast<double>(measurements.size() + 1),
                              .error = std::max(run.residual, invisible),
                              .operations = run.products});
    }
    return measurements;
  };
}

Measure residuals_of(VectorXd (*attempt)(const LcpProblem& problem)) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const PlantedLcp& lcp : test::suite()) {
      const VectorXd z = attempt(lcp.problem);
      measurements.push_back({.x = static_cast<double>(measurements.size() + 1),
                              .error = z.allFinite() ? lcp_residual(lcp.problem, z) : 1.0});
    }
    return measurements;
  };
}

VectorXd misprinted(const LcpProblem& problem) {
  return bare_fischer(problem, VectorXd::Zero(problem.offset.size()), published_radius, 20);
}

Measure unsolved(const Method& method) {
  return [&method](Size) {
    std::vector<Measurement> measurements;
    for (int half_decade = 0; half_decade <= 9; ++half_decade) {
      const double products = std::pow(10.0, 0.5 * half_decade);
      const auto left = std::ranges::count_if(
          runs_of(method), [&](const Run& run) { return !run.solved || run.products > products; });
      measurements.push_back({.x = products, .error = static_cast<double>(left)});
    }
    return measurements;
  };
}

// Measures the residuals of a problem if at most 1, 2, 4, ... iterations are allowed.
Measure history(const Method& method, const std::function<LcpProblem()>& make) {
  return [&method, make](Size size) {
    const LcpProblem problem = make();
    const auto m = static_cast<double>(problem.offset.size());
    std::vector<Measurement> measurements;
    const int most = size == Size::full ? 16384 : 2048;
    for (int allowed = 1; allowed <= most; allowed *= 2) {
      const LcpResult result = method.solve(problem, {.max_iterations = allowed});
      if (!measurements.empty() && result.iterations <= measurements.back().x) break;
      const double k = result.iterations;
      measurements.push_back({.x = k,
                              .error = std::max(result.residual, invisible),
                              .operations = method.products(k, m)});
      if (solved(result)) break;
    }
    return measurements;
  };
}

Experiment work(const std::string& key, const std::string& title,
                const std::function<LcpProblem()>& make) {
  Experiment experiment{.key = key,
                        .title = title,
                        .x = "iterations k",
                        .error = "residual, at least 1e-17",
                        .lines = {},
                        .work_precision = true,
                        .operation = "products with the matrix"};
  for (const Method& method : methods()) {
    if (method.key == "all_sets") continue;  // this solver has one result only
    experiment.lines.push_back(
        {.key = method.key, .label = method.label, .measure = history(method, make)});
  }
  return experiment;
}

}  // namespace

Experiment suite_residuals() {
  Experiment experiment{.key = "suite",
                        .title = "Twenty problems: residuals",
                        .x = "number of the problem",
                        .error = "residual, at least 1e-17",
                        .axes = Axes::nominal,
                        .lines = {},
                        .operation = "products with the matrix"};
  for (const Method& method : methods()) {
    experiment.lines.push_back(
        {.key = method.key, .label = method.label, .measure = residuals(method)});
  }
  experiment.lines[0].claim =
      Claim{.id = "11_10",
            .statement = "Lemke solves all twenty problems to rounding.",
            .law = Identity{1e-12},
            .reason =
                "all have solutions, and semidefinite or Murty's matrices; the last solve "
                "leaves the rounding of 400 terms at most",
            .api = {"stokesbook::lemke"}};
  experiment.lines[0].control = Control{"the equation M z = -q, negative entries of z dropped",
                                        residuals_of(clipped_equation)};
  experiment.lines[1].claim =
      Claim{.id = "11_11",
            .statement = "Fischer-Newton solves all twenty problems to its tolerance.",
            .law = Identity{1e-10},
            .reason =
                "the tolerance is what was asked for; all have solutions, and M + eps has "
                "positive principal minors, so that no point but a solution is stationary",
            .api = {"stokesbook::fischer_newton"}};
  experiment.lines[1].control =
      Control{"sqrt(z + w) in the Jacobian, as printed", residuals_of(misprinted)};
  return experiment;
}

Experiment profile() {
  Experiment experiment{.key = "profile",
                        .title = "Twenty problems: number of those not solved at a cost",
                        .x = "products with the matrix P",
                        .error = "problems not solved, of twenty",
                        .lines = {}};
  for (const Method& method : methods()) {
    experiment.lines.push_back(
        {.key = method.key, .label = method.label, .measure = unsolved(method)});
  }
  return experiment;
}

Experiment definite() {
  return work("definite", "Work and precision: a definite matrix, 100 rows",
              [] { return planted("", definite_matrix(100, 100), 100, true).problem; });
}

Experiment singular() {
  return work("singular", "Work and precision: 25 degrees of freedom, 100 rows",
              [] { return planted("", semidefinite_matrix(100, 25, 2), 2, false).problem; });
}

Experiment long_chain() {
  return work("long_chain", "Work and precision: a chain of 100", [] { return chain(100); });
}

Experiment hilbert() {
  return work("hilbert", "Work and precision: Hilbert's matrix, 12 rows",
              [] { return planted("", hilbert_matrix(12), 4, false).problem; });
}

}  // namespace stokesbook::verification::lcp
