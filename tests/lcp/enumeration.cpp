// Compares Lemke's method with an enumeration of all 2^m sets of contacts, which lists every
// solution with a regular M_AA. The list must contain Lemke's solution, and Lemke's method must
// report a ray (11.5) exactly if no solution exists.
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "support/lcp_solvers.hpp"

namespace stokesbook::test {

namespace {

// Returns the solutions with a regular M_AA. If a positive semidefinite problem has solutions, the
// list contains at least one of them.
std::vector<VectorXd> all_solutions(const LcpProblem& problem) {
  const Index m = problem.offset.size();
  std::vector<VectorXd> solutions;
  for (unsigned set = 0; set < 1u << m; ++set) {
    std::vector<Index> active;
    for (Index i = 0; i < m; ++i) {
      if (set >> i & 1u) active.push_back(i);
    }
    VectorXd z = VectorXd::Zero(m);
    if (!active.empty()) {
      const Eigen::FullPivLU<MatrixXd> lu(problem.matrix(active, active));
      if (!lu.isInvertible()) continue;
      z(active) = lu.solve(-problem.offset(active));
    }
    const VectorXd w = problem.offset + problem.matrix * z;
    if (z.minCoeff() > -1e-9 && w.minCoeff() > -1e-9) solutions.push_back(z);
  }
  return solutions;
}

bool is_among(const VectorXd& z, const std::vector<VectorXd>& solutions) {
  return std::ranges::any_of(solutions,
                             [&](const VectorXd& other) { return largest(z - other) < 1e-8; });
}

MatrixXd small_integers(Index rows, Index columns, std::mt19937& generator) {
  std::uniform_int_distribution<int> integer(-2, 2);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return double(integer(generator)); });
}

// Solves random semidefinite problems of integers, which have many ties, duplicates and empty rows.
// About a sixth of them have no solution.
void solve_semidefinite_problems(int trials) {
  std::mt19937 generator(1);
  int without = 0, with = 0, degenerate = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Index m = 1 + trial % 8;
    const MatrixXd factor = small_integers(m, 1 + trial % 5, generator);
    MatrixXd matrix = factor * factor.transpose();
    if (trial % 3 == 0) {
      const MatrixXd twist = small_integers(m, m, generator);
      matrix += twist - twist.transpose();
    }
    const LcpProblem problem{matrix, small_integers(m, 1, generator)};
    const auto solutions = all_solutions(problem);
    const LcpResult result = lemke(problem);
    BOOST_TEST_CONTEXT("trial " << trial << "\n" << matrix << "\n" << problem.offset.transpose()) {
      if (solutions.empty()) {
        BOOST_TEST((result.status == LcpStatus::ray));
        BOOST_TEST(proves_no_solution(result.ray, problem));
        ++without;
      } else {
        BOOST_TEST(solved(result));
        BOOST_TEST(is_among(result.z, solutions));
        ++with;
        degenerate += result.degenerate > 0;
      }
    }
  }
  BOOST_TEST(without > 3 * trials / 20);
  BOOST_TEST(with > trials / 2);
  BOOST_TEST(degenerate > trials / 20);
}

}  // namespace

BOOST_AUTO_TEST_CASE(semidefinite_problems_of_integers) {
  solve_semidefinite_problems(400);
}

BOOST_AUTO_TEST_CASE(many_semidefinite_problems_of_integers, *boost::unit_test::label("full")) {
  solve_semidefinite_problems(2000);
}

BOOST_AUTO_TEST_CASE(any_matrix_at_all) {
  // For such matrices, a problem with a ray may have a solution, so the test ignores rays. If
  // Lemke's method returns a solution, the solution must fulfil the problem.
  std::mt19937 generator(2);
  int found = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Index m = 1 + trial % 8;
    const LcpProblem problem{normal_matrix(m, m, static_cast<unsigned>(trial)),
                             small_integers(m, 1, generator)};
    const LcpResult result = lemke(problem);
    BOOST_TEST((result.status != LcpStatus::stalled), "trial " << trial);
    if (!solved(result)) continue;
    BOOST_TEST(is_among(result.z, all_solutions(problem)), "trial " << trial);
    ++found;
  }
  BOOST_TEST(found > 300);
}

BOOST_AUTO_TEST_CASE(definite_problems_with_every_solver) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Index m = 1 + seed % 8;
    const LcpProblem problem{definite_matrix(m, seed), normal_matrix(m, 1, seed + 1000)};
    const auto solutions = all_solutions(problem);
    BOOST_TEST(solutions.size() == 1u);
    for (const auto& [name, solve] : solvers()) {
      const LcpResult result = solve(problem, {});
      BOOST_TEST(solved(result), name << ", seed " << seed);
      BOOST_TEST(is_among(result.z, solutions), name << ", seed " << seed);
    }
  }
}

}  // namespace stokesbook::test
