// Checks that status, number of iterations and residual do not depend on the units, of single rows
// or of all rows, and that the solution does not depend on the order of the rows.
#include <boost/test/unit_test.hpp>

#include "lcp/scaled_problem.hpp"
#include "support/lcp_solvers.hpp"

namespace stokesbook::test {

namespace {

// Returns powers of two: scaling adds no rounding errors.
VectorXd binary_scale(Index m, unsigned seed) {
  return random_scale(m, seed).unaryExpr(
      [](double s) { return std::exp2(std::round(std::log2(s))); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(units_of_single_rows) {
  for (const PlantedLcp& lcp : suite()) {
    const Index m = lcp.z.size();
    const VectorXd scale = binary_scale(m, 7);
    const PlantedLcp other = in_other_units(lcp, scale);
    for (const auto& [name, solve] : solvers()) {
      const LcpResult here = solve(lcp.problem, {}), there = solve(other.problem, {});
      BOOST_TEST_CONTEXT(name << ": " << lcp.name) {
        BOOST_TEST((here.status == there.status));
        BOOST_TEST(std::abs(here.residual - there.residual) <= 1e-10 + 0.5 * here.residual);
        if (!solved(here)) continue;
        const VectorXd w = lcp.problem.matrix * (there.z.cwiseProduct(scale) - here.z);
        BOOST_TEST(largest(w) <= 1e-8 * largest(lcp.problem.offset));
      }
    }
    BOOST_TEST(lemke(lcp.problem).iterations == lemke(other.problem).iterations, lcp.name);
    BOOST_TEST(std::abs(lcp_residual(lcp.problem, VectorXd::Ones(m)) -
                        lcp_residual(other.problem, scale.cwiseInverse())) <=
               1e-12 * lcp_residual(lcp.problem, VectorXd::Ones(m)));
  }
}

BOOST_AUTO_TEST_CASE(units_of_all) {
  // All lengths are multiplied by 2^20 and all forces by 2^-40. Therefore M is multiplied by 2^60,
  // and q by 2^20.
  for (const PlantedLcp& lcp : suite()) {
    const LcpProblem other{std::exp2(60.0) * lcp.problem.matrix,
                           std::exp2(20.0) * lcp.problem.offset};
    for (const auto& [name, solve] : solvers()) {
      const LcpResult here = solve(lcp.problem, {}), there = solve(other, {});
      BOOST_TEST((here.status == there.status), name << ": " << lcp.name);
      BOOST_TEST(here.iterations == there.iterations, name << ": " << lcp.name);
      BOOST_TEST((here.z == std::exp2(40.0) * there.z), name << ": " << lcp.name);
    }
  }
}

BOOST_AUTO_TEST_CASE(order_of_the_rows) {
  std::mt19937 generator(3);
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const PlantedLcp lcp = planted("definite", definite_matrix(20, seed), seed, true);
    std::vector<Index> order(20);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    std::ranges::shuffle(order, generator);
    const LcpProblem other{lcp.problem.matrix(order, order), lcp.problem.offset(order)};
    for (const auto& [name, solve] : solvers()) {
      const LcpResult result = solve(other, {});
      BOOST_TEST(solved(result), name);
      BOOST_TEST(largest(result.z - lcp.z(order)) < 1e-7, name);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_solution_of_a_symmetric_problem_is_a_minimum) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const PlantedLcp lcp = planted("rank 5", semidefinite_matrix(20, 5, seed), seed, false);
    const LcpProblem& problem = lcp.problem;
    const auto value = [&](const VectorXd& z) {
      return 0.5 * z.dot(problem.matrix * z) + problem.offset.dot(z);
    };
    const VectorXd z = lemke(problem).z;
    for (unsigned trial = 0; trial < 20; ++trial) {
      const VectorXd other = (z + 0.1 * normal_matrix(20, 1, 100 * seed + trial)).cwiseMax(0.0);
      BOOST_TEST(value(other) >= value(z) - 1e-12);
    }
  }
}

}  // namespace stokesbook::test
