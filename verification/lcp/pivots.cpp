// Counts Lemke's pivots on problems for which the number is known, and tests that rays prove that
// there is no solution (11.5).
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "variants.hpp"

namespace stokesbook::verification::lcp {

using namespace study;
using namespace test;

namespace {

using ProblemOfSize = LcpProblem (*)(Index m);

LcpProblem transposed_murty(Index m) {
  LcpProblem problem = murty(m);
  problem.matrix.transposeInPlace();
  return problem;
}

LcpProblem random_definite(Index m) {
  return planted("definite", definite_matrix(m, static_cast<unsigned>(m)), 1, true).problem;
}

// Measures the difference between the number of Lemke's pivots and a known count.
Measure miscount(ProblemOfSize make, double (*count)(double m)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index m = 2; m <= (size == Size::full ? 14 : 10); m += 2) {
      const auto x = static_cast<double>(m);
      const double pivots = lemke(make(m)).iterations;
      measurements.push_back(
          {.x = x, .error = std::abs(pivots - count(x)), .unknowns = x, .operations = pivots});
    }
    return measurements;
  };
}

double two_to_the(double m) {
  return std::exp2(m);
}

double one_more(double m) {
  return m + 1.0;
}

enum class Coupling {
  both_ways,
  one_way  ///< a planted defect: only the contacts before a contact act on it
};

// Returns the largest relative violation of M^T v <= 0 by the ray v. Returns 1 if q . v < 0 is
// violated, or if there is no ray.
double flaw(const LcpProblem& problem, Coupling coupling) {
  LcpProblem solved = problem;
  if (coupling == Coupling::one_way) {
    solved.matrix = problem.matrix.triangularView<Eigen::Lower>();
  }
  const LcpResult result = lemke(solved);
  if (result.status != LcpStatus::ray) return 1.0;
  const VectorXd& v = result.ray;
  if (!(problem.offset.dot(v) < 0.0)) return 1.0;
  return std::max(0.0, (problem.matrix.transpose() * v).maxCoeff()) /
         (largest(v) * problem.matrix.cwiseAbs().maxCoeff());
}

// Returns a problem without solution, in which each contact occurs twice, up to 1e-6. All forces
// together balance and cause no motion, but q requires a motion.
LcpProblem pinched(Index m, unsigned seed) {
  MatrixXd factor = normal_matrix(m, m / 4, seed);
  factor.row(m - 1) -= factor.colwise().sum();
  VectorXd offset = normal_matrix(2 * m, 1, seed);
  offset.array() -= offset.mean() + 0.1;
  return {near_duplicates(factor * factor.transpose()), offset};
}

Measure flaws(Coupling coupling) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index m = 8; m <= (size == Size::full ? 128 : 32); m *= 2) {
      double worst = 0.0;
      for (unsigned seed = 1; seed <= 20; ++seed) {
        worst = std::max(worst, flaw(pinched(m, seed), coupling));
      }
      measurements.push_back({.x = 2.0 * static_cast<double>(m), .error = worst});
    }
    return measurements;
  };
}

}  // namespace

Experiment pivots() {
  return {
      .key = "pivots",
      .title = "Counts of Lemke's pivots",
      .x = "rows m",
      .error = "difference of the number of pivots from the prediction",
      .axes = Axes::semi_log,
      .lines =
          {{.key = "murty",
            .label = "Murty's matrix, 2^m",
            .measure = miscount(murty, two_to_the),
            .claim = Claim{.id = "11_1",
                           .statement = "On Murty's matrix Lemke takes exactly 2^m pivots.",
                           .law = Identity{0.0},
                           .reason = "an additional row doubles the path: by induction on m in the "
                                     "chapter; the pivots' numbers are integers, so that there is "
                                     "no rounding",
                           .api = {"stokesbook::lemke"}},
            .control =
                Control{"Murty's matrix transposed", miscount(transposed_murty, two_to_the)}},
           {.key = "chain",
            .label = "a chain, m + 1",
            .measure = miscount(chain, one_more),
            .claim =
                Claim{.id = "11_2",
                      .statement = "On a chain that is pushed together Lemke takes m + 1 pivots.",
                      .law = Identity{0.0},
                      .reason = "t enters, then each of the m multipliers; where no entry off the "
                                "diagonal is positive, none leaves again",
                      .api = {"stokesbook::lemke"}},
            .control = Control{"random definite matrices", miscount(random_definite, one_more)}}},
      .operation = "pivots"};
}

Experiment rays() {
  return {.key = "rays",
          .title = "Rays: proofs that there is no solution",
          .x = "rows m",
          .error = "positive part of M^T v over |M| |v|; 1 unless q v < 0; worst of twenty",
          .lines = {{.key = "lemke",
                     .label = "Lemke's ray",
                     .measure = flaws(Coupling::both_ways),
                     .claim = Claim{.id = "11_3",
                                    .statement = "On semidefinite problems without a solution, of "
                                                 "nearly repeated rows, Lemke's ray is a proof.",
                                    .law = Identity{1e-10},
                                    .reason = "v >= 0, M^T v <= 0, q v < 0 exclude a solution; "
                                              "pivots are accepted down to 1e-11 of a column",
                                    .api = {"stokesbook::lemke"}},
                     .control = Control{"contacts that feel only those before them",
                                        flaws(Coupling::one_way)}}}};
}

}  // namespace stokesbook::verification::lcp
