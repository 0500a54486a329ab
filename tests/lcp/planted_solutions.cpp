// Checks random problems with planted solutions, 30 % of whose pairs are degenerate. The matrices
// are definite, singular, with nearly equal rows, as ill conditioned as Hilbert's matrix, in mixed
// units, or not symmetric.
#include <boost/test/unit_test.hpp>

#include "lcp/scaled_problem.hpp"
#include "support/lcp_solvers.hpp"

namespace stokesbook::test {

namespace {

constexpr unsigned seeds = 100;

Index size_of(unsigned seed) {
  return 4 + static_cast<Index>(seed * 7919u % 57u);
}

// Returns problems with every kind of matrix that contact produces, and with more difficult
// matrices.
std::vector<PlantedLcp> problems_of(unsigned seed) {
  const Index m = size_of(seed);
  const MatrixXd definite = definite_matrix(m, seed), rank = semidefinite_matrix(m, m / 4, seed);
  const MatrixXd twist = normal_matrix(m, m, seed + 1000);
  const MatrixXd rows = normal_matrix(m, m / 3 + 1, seed),
                 moved = rows + 1e-3 * normal_matrix(m, m / 3 + 1, seed + 1000);
  std::vector<PlantedLcp> problems{
      planted("definite", definite, seed, true),
      planted("rank m / 4", rank, seed, false),
      planted("Hilbert", hilbert_matrix(2 + seed % 30), seed, false),
      planted("near duplicates", near_duplicates(definite), seed, false),
      planted("near duplicates of rank m / 2", near_duplicates(rank), seed, false),
      planted("positive, not symmetric", 0.1 * definite + 0.3 * (twist - twist.transpose()), seed,
              true),
      planted("J B J_f, nearly symmetric", rows * moved.transpose(), seed, false)};
  problems.push_back(in_other_units(problems[0], random_scale(m, seed)));
  problems.push_back(in_other_units(problems[1], random_scale(m, seed)));
  return problems;
}

void check_verdicts(unsigned last_seed) {
  unsigned all = 0;
  for (unsigned seed = 1; seed <= last_seed; ++seed) {
    for (const PlantedLcp& lcp : problems_of(seed)) {
      for (const auto& [name, solve] : solvers()) {
        const LcpResult result = solve(lcp.problem, {});
        BOOST_TEST_CONTEXT(name << ": " << lcp.name << ", seed " << seed) {
          BOOST_TEST(result.z.minCoeff() >= 0.0);
          BOOST_TEST((result.status == LcpStatus::ray) == (result.ray.size() > 0));
          // The residual is computed twice, and the two orders of summation round differently.
          const LcpScaling scaling = scale_problem(lcp.problem).scaling;
          const double size = largest(result.z.cwiseQuotient(scaling.size * scaling.scale));
          BOOST_TEST(std::abs(lcp_residual(lcp.problem, result.z) - result.residual) <=
                     1e-13 * (1.0 + size));
          BOOST_TEST(solved(result) == (result.residual <= 1e-10));
        }
        all += solved(result);
      }
    }
  }
  BOOST_TEST(all > 20 * last_seed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(lemke_solves_all_of_them_to_rounding) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    for (const PlantedLcp& lcp : problems_of(seed)) {
      const LcpResult result = lemke(lcp.problem);
      BOOST_TEST_CONTEXT(lcp.name << ", seed " << seed << ", m = " << lcp.z.size()) {
        BOOST_TEST(solved(result));
        BOOST_TEST(result.residual < 1e-12);
        BOOST_TEST(result.iterations <= 10 + 4 * lcp.z.size());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(rays_of_large_problems_prove_that_there_is_no_solution) {
  // Two contacts have rows that agree to 1e-6, but require different gaps.
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Index m = 20 + size_of(seed);
    const MatrixXd matrix = near_duplicates(semidefinite_matrix(m, m / 4, seed));
    const LcpProblem problem{matrix, normal_matrix(2 * m, 1, seed)};
    const LcpResult result = lemke(problem);
    BOOST_TEST((result.status == LcpStatus::ray), "seed " << seed);
    BOOST_TEST(proves_no_solution(result.ray, problem), "seed " << seed);
  }
}

BOOST_AUTO_TEST_CASE(what_is_called_solved_is) {
  check_verdicts(15);
}

BOOST_AUTO_TEST_CASE(what_is_called_solved_is_for_many_seeds, *boost::unit_test::label("full")) {
  check_verdicts(seeds);
}

BOOST_AUTO_TEST_CASE(unique_solutions_are_found) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const auto m = size_of(seed);
    const PlantedLcp lcp = planted("definite", definite_matrix(m, seed), seed, true);
    for (const auto& [name, solve] : solvers()) {
      const LcpResult result = solve(lcp.problem, {});
      BOOST_TEST_CONTEXT(name << ", seed " << seed) {
        BOOST_TEST(solved(result));
        // The condition number is below 50.
        BOOST_TEST(largest(result.z - lcp.z) < 1e-7);
      }
    }
    BOOST_TEST(largest(lemke(lcp.problem).z - lcp.z) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(where_z_is_not_unique_w_is) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Index m = size_of(seed);
    const PlantedLcp lcp = planted("rank", semidefinite_matrix(m, m / 4, seed), seed, false);
    BOOST_TEST(largest(lcp.problem.matrix * (lemke(lcp.problem).z - lcp.z)) < 1e-12);
    const LcpResult newton = fischer_newton(lcp.problem);
    if (solved(newton)) BOOST_TEST(largest(lcp.problem.matrix * (newton.z - lcp.z)) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(fischer_newton_solves_nearly_all) {
  int unsolved = 0, most = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    for (const PlantedLcp& lcp : problems_of(seed)) {
      const LcpResult result = fischer_newton(lcp.problem);
      if (!solved(result)) ++unsolved;
      if (solved(result)) most = std::max(most, result.iterations);
      BOOST_TEST(result.residual < 1e-6, lcp.name << ", seed " << seed);
    }
  }
  // The unsolved problems among 900 problems have matrices that are as ill conditioned as Hilbert's
  // matrix, or singular matrices with nearly equal rows.
  BOOST_TEST(unsolved <= 4);
  BOOST_TEST(most <= 100);
}

BOOST_AUTO_TEST_CASE(degenerate_pairs_are_counted) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const PlantedLcp lcp = planted("definite", definite_matrix(size_of(seed), seed), seed, true);
    const VectorXd w = lcp.problem.offset + lcp.problem.matrix * lcp.z;
    int planted_pairs = 0;
    for (Index i = 0; i < w.size(); ++i) planted_pairs += lcp.z[i] == 0.0 && std::abs(w[i]) < 1e-9;
    BOOST_TEST(lemke(lcp.problem).degenerate == planted_pairs);
  }
}

}  // namespace stokesbook::test
