// Counts the iterations of the solvers on chains of contacts of various lengths.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "variants.hpp"

namespace stokesbook::verification::lcp {

using namespace study;
using namespace test;

namespace {

constexpr double pi = std::numbers::pi;

double distance_from_solution(const VectorXd& z) {
  return largest(z - VectorXd::Ones(z.size()));
}

// Returns a number of sweeps after which only the slowest part of the error is left, up to a factor
// exp(-9 pi^2 / 4).
int enough_sweeps(Index m) {
  return static_cast<int>(3 * (m + 1) * (m + 1) / 4) + 1;
}

Measure factors(bool in_turn) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index m = 5; m <= (size == Size::full ? 80 : 40); m *= 2) {
      const int sweeps = enough_sweeps(m);
      const auto error = [&](int count) {
        if (!in_turn) return distance_from_solution(swept(chain(m), count, false));
        return distance_from_solution(
            projected_gauss_seidel(chain(m), {.tolerance = 0.0, .max_iterations = count}).z);
      };
      const double factor = std::pow(error(sweeps + 10) / error(sweeps), 0.1);
      const auto x = static_cast<double>(m);
      const double theory = std::pow(std::cos(pi / (x + 1.0)), 2);
      measurements.push_back({.x = x, .error = std::abs(factor - theory)});
    }
    return measurements;
  };
}

using CountOfSize = std::function<double(Index m)>;

Measure counts(const CountOfSize& count) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index m = 10; m <= (size == Size::full ? 160 : 80); m *= 2) {
      measurements.push_back({.x = static_cast<double>(m), .error = count(m)});
    }
    return measurements;
  };
}

// Returns the number of sweeps until the error of z is below 1e-3, by bisection.
double sweeps_for_three_digits(const LcpProblem& problem, const VectorXd& z) {
  const auto near = [&](int sweeps) {
    const LcpOptions options{.tolerance = 0.0, .max_iterations = sweeps};
    return largest(projected_gauss_seidel(problem, options).z - z) < 1e-3;
  };
  int few = 0, enough = 1;
  while (!near(enough)) {
    few = enough;
    enough *= 2;
  }
  while (enough - few > 1) {
    const int middle = (few + enough) / 2;
    (near(middle) ? enough : few) = middle;
  }
  return enough;
}

double sweeps_of_chain(Index m) {
  return sweeps_for_three_digits(chain(m), VectorXd::Ones(m));
}

double sweeps_of_tied_chain(Index m) {
  const MatrixXd matrix = chain_matrix(m) + MatrixXd::Identity(m, m);
  return sweeps_for_three_digits({matrix, -matrix * VectorXd::Ones(m)}, VectorXd::Ones(m));
}

double minimum_map_steps(const LcpProblem& problem) {
  return minimum_map_newton(problem, {.max_iterations = 1000}).iterations;
}

}  // namespace

Experiment sweeps() {
  return {
      .key = "sweeps",
      .title = "A chain: factor of the error by a sweep of Gauss-Seidel",
      .x = "rows m",
      .error = "factor of the error by a sweep, distance from its formula",
      .lines = {
          {.key = "in_turn",
           .label = "projected Gauss-Seidel, cos²(π/(m + 1))",
           .measure = factors(true),
           .claim =
               Claim{.id = "11_4",
                     .statement = "On a chain a sweep multiplies the error by "
                                  "cos²(π/(m + 1)).",
                     .law = Identity{1e-7},
                     .reason = "Jacobi's factor cos(pi/(m + 1)), squared; after 3 (m + 1)^2/4 "
                               "sweeps the next part of the error is exp(-9 pi^2/4) of the slowest",
                     .api = {"stokesbook::projected_gauss_seidel"}},
           .control = Control{"all rows swept with the old z", factors(false)}}}};
}

Experiment chains() {
  return {
      .key = "chains",
      .title = "A chain: iterations as it grows longer",
      .x = "rows m",
      .error = "iterations: pivots, steps, sweeps to three digits, products",
      .lines = {
          {.key = "gauss_seidel",
           .label = "projected Gauss-Seidel, three digits only",
           .measure = counts(sweeps_of_chain),
           .claim = Claim{.id = "11_5",
                          .statement = "Sweeps for a given accuracy grow with the square of the "
                                       "length of the chain.",
                          .law = Algebraic{-2.0, 0.15},
                          .reason = "log cos²(π/(m + 1)) is about -pi^2/(m + 1)^2: the effect of "
                                    "a push diffuses",
                          .api = {"stokesbook::projected_gauss_seidel"}},
           .control = Control{"every row tied to a wall by 3 on the diagonal",
                              counts(sweeps_of_tied_chain)}},
          {.key = "minimum_map",
           .label = "minimum-map Newton",
           .measure = counts([](Index m) { return minimum_map_steps(chain(m)); }),
           .claim =
               Claim{.id = "11_6",
                     .statement = "Steps of the minimum map grow with the length of the chain.",
                     .law = Algebraic{-1.0, 0.1},
                     .reason = "a step adds a contact at both ends of the gap in the chain: m/2 "
                               "of them",
                     .api = {"stokesbook::minimum_map_newton"}},
           .control = Control{"random definite matrices", counts([](Index m) {
                                const MatrixXd matrix = definite_matrix(m, 1);
                                return minimum_map_steps(planted("", matrix, 1, true).problem);
                              })}},
          {.key = "barzilai_borwein",
           .label = "Barzilai-Borwein",
           .measure = counts([](Index m) { return barzilai_borwein(chain(m)).iterations; })},
          {.key = "lemke", .label = "Lemke", .measure = counts([](Index m) {
                                               return lemke(chain(m)).iterations;
                                             })},
          {.key = "fischer",
           .label = "Fischer-Newton",
           .measure = counts([](Index m) { return fischer_newton(chain(m)).iterations; })}}};
}

}  // namespace stokesbook::verification::lcp
