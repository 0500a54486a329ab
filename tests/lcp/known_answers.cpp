// Checks every solver on problems that can be solved by hand: the solver must solve some problems,
// and must report the others as not solved.
#include <limits>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "lcp/scaled_problem.hpp"
#include "support/lcp_solvers.hpp"

namespace stokesbook::test {

namespace {

// Returns a problem of two unknowns (M, q).
LcpProblem two(double a, double b, double c, double d, double p, double q) {
  return {matrix2(a, b, c, d), vector2(p, q)};
}

LcpProblem one(double m, double q) {
  return {MatrixXd::Constant(1, 1, m), VectorXd::Constant(1, q)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_unknown) {
  for (const auto& [name, solve] : solvers()) {
    const LcpResult result = solve(one(2.0, -1.0), {});
    BOOST_TEST(solved(result), name);
    BOOST_TEST(std::abs(result.z[0] - 0.5) < 1e-10, name);
  }
}

BOOST_AUTO_TEST_CASE(offsets_that_are_not_negative_are_solved_by_zero) {
  for (const auto& [name, solve] : solvers()) {
    const LcpResult result = solve(two(1.0, -3.0, 2.0, 1.0, 0.0, 4.0), {});
    BOOST_TEST(solved(result), name);
    BOOST_TEST(result.z == VectorXd::Zero(2), name);
    BOOST_TEST(result.degenerate == 1, name);  // z_0 = w_0 = 0
    const LcpResult empty = solve({MatrixXd(0, 0), VectorXd(0)}, {});
    BOOST_TEST(solved(empty), name);
    BOOST_TEST(empty.z.size() == 0, name);
  }
}

BOOST_AUTO_TEST_CASE(many_solutions) {
  // The solutions of the first problem are all z >= 0 with z_0 + z_1 = 1, and the solutions of the
  // second problem are all z >= 0 with z_0 - z_1 = 1.
  for (const auto& [name, solve] : solvers()) {
    const LcpResult sum = solve(two(1.0, 1.0, 1.0, 1.0, -1.0, -1.0), {});
    BOOST_TEST(solved(sum), name);
    BOOST_TEST(std::abs(sum.z[0] + sum.z[1] - 1.0) < 1e-9, name);
    const LcpResult difference = solve(two(1.0, -1.0, -1.0, 1.0, -1.0, 1.0), {});
    BOOST_TEST(solved(difference), name);
    BOOST_TEST(std::abs(difference.z[0] - difference.z[1] - 1.0) < 1e-9, name);
  }
}

BOOST_AUTO_TEST_CASE(no_solution_is_never_reported_as_one) {
  // The first problem is 0 z = 1. In the second problem, two bodies are pushed through each other
  // from both sides. The third problem is the second problem in other units: without scaling, its
  // second row is negligible.
  const LcpProblem problems[] = {one(0.0, -1.0), two(1.0, -1.0, -1.0, 1.0, -1.0, -1.0),
                                 two(1e8, -1.0, -1.0, 1e-8, -1e4, -1e-4)};
  for (const LcpProblem& problem : problems) {
    const LcpResult ray = lemke(problem);
    BOOST_TEST((ray.status == LcpStatus::ray));
    BOOST_TEST(proves_no_solution(ray.ray, problem));
    for (const auto& [name, solve] : solvers()) {
      if (problem.matrix(0, 0) == 0.0 && std::string(name) == "projected Gauss-Seidel") continue;
      const LcpResult result = solve(problem, {});
      BOOST_TEST(!solved(result), name);
      BOOST_TEST(result.residual > 1e-3, name);
    }
  }
}

BOOST_AUTO_TEST_CASE(gauss_seidel_names_the_entry_that_it_cannot_divide_by) {
  BOOST_CHECK_EXCEPTION(projected_gauss_seidel(two(1.0, 0.0, 0.0, -2.0, -1.0, -1.0)),
                        std::invalid_argument, [](const std::invalid_argument& error) {
                          return std::string(error.what()).find("M_ii is -2 for i = 1") !=
                                 std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(a_chain_of_fifty) {
  for (const auto& [name, solve] : solvers()) {
    const LcpResult result = solve(chain(50), {});
    if (std::string(name) == "projected Gauss-Seidel") {
      BOOST_TEST(!solved(result));
      BOOST_TEST(result.iterations == 1000);
      BOOST_TEST(result.residual > 1e-5);
      continue;
    }
    BOOST_TEST(solved(result), name);
    // The error is at most the residual divided by the smallest eigenvalue, 4 sin^2(pi / 102).
    BOOST_TEST(largest(result.z - VectorXd::Ones(50)) < 1e-10 * 50.0 / 0.0038, name);
  }
  BOOST_TEST(largest(lemke(chain(50)).z - VectorXd::Ones(50)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_chain_of_four_hundred) {
  const LcpResult pivoted = lemke(chain(400));
  BOOST_TEST(solved(pivoted));
  BOOST_TEST(pivoted.iterations <= 402);
  BOOST_TEST(largest(pivoted.z - VectorXd::Ones(400)) < 1e-12);
  const LcpResult newton = fischer_newton(chain(400));
  BOOST_TEST(solved(newton));
  BOOST_TEST(newton.iterations <= 10);
  BOOST_TEST(largest(newton.z - VectorXd::Ones(400)) < 1e-7);
  // One iteration moves each end of the set of contacts by one index.
  BOOST_TEST(!solved(minimum_map_newton(chain(400))));
  const LcpResult patient = minimum_map_newton(chain(400), {.max_iterations = 400});
  BOOST_TEST(solved(patient));
  BOOST_TEST(patient.iterations >= 199);
  for (const LcpSolver& solve : {LcpSolver{projected_gauss_seidel}, LcpSolver{barzilai_borwein}}) {
    const LcpResult result = solve(chain(400), {});
    BOOST_TEST((result.status == LcpStatus::stalled));
    BOOST_TEST(result.residual > 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(lemke_visits_all_corners_of_murtys_problem) {
  for (Index m = 1; m <= 12; ++m) {
    const LcpResult result = lemke(murty(m));
    BOOST_TEST(solved(result));
    BOOST_TEST(result.iterations == 1 << m);
    BOOST_TEST((result.z == VectorXd::Unit(m, 0)));
  }
  for (const auto& [name, solve] : solvers()) {
    const LcpResult result = solve(murty(12), {});
    BOOST_TEST(solved(result), name);
    BOOST_TEST(largest(result.z - VectorXd::Unit(12, 0)) < 1e-9, name);
  }
}

BOOST_AUTO_TEST_CASE(too_few_pivots_are_reported) {
  const LcpResult result = lemke(murty(8), {.max_iterations = 255});
  BOOST_TEST((result.status == LcpStatus::stalled));
  BOOST_TEST(result.iterations == 255);
  BOOST_TEST(result.residual > 0.1);
}

BOOST_AUTO_TEST_CASE(a_problem_on_which_exchanges_of_single_indices_cycle) {
  // Murty's problem has the solution z = 1/3 in all components. If a solver exchanges one index at
  // a time, the sets of contacts can cycle: {1}, {1, 2}, {2}, {2, 3}, {3}, {3, 1}, {1}.
  MatrixXd matrix(3, 3);
  matrix << 1.0, 2.0, 0.0, 0.0, 1.0, 2.0, 2.0, 0.0, 1.0;
  const LcpProblem problem{matrix, -VectorXd::Ones(3)};
  for (const auto& [name, solve] : solvers()) {
    const LcpResult result = solve(problem, {});
    BOOST_TEST(solved(result) == (lcp_residual(problem, result.z) <= 1e-10), name);
  }
  for (const LcpSolver& solve : {LcpSolver{lemke}, LcpSolver{fischer_newton}}) {
    const LcpResult result = solve(problem, {});
    BOOST_TEST(solved(result));
    BOOST_TEST(largest(result.z - VectorXd::Constant(3, 1.0 / 3.0)) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(sizes_that_do_not_agree_and_numbers_that_are_not_finite_throw) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, solve] : solvers()) {
    BOOST_CHECK_THROW(solve({MatrixXd::Identity(2, 3), VectorXd::Ones(2)}, {}),
                      std::invalid_argument);
    BOOST_CHECK_THROW(solve({MatrixXd::Identity(3, 3), VectorXd::Ones(2)}, {}),
                      std::invalid_argument);
    BOOST_CHECK_THROW(solve(one(1.0, nan), {}), std::domain_error);
    BOOST_CHECK_THROW(solve(one(nan, -1.0), {}), std::domain_error);
    if (std::string(name) == "Lemke") continue;
    BOOST_CHECK_THROW(solve(one(1.0, -1.0), {.guess = VectorXd::Ones(2)}), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_is_no_solution) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ScaledLcp scaled = scale_problem(chain(9));
  for (Index i = 0; i < 9; ++i) {
    VectorXd z = VectorXd::Ones(9);
    z[i] = nan;
    const LcpResult result = make_result(scaled.scaling, z, VectorXd::Zero(9), 1e-10);
    BOOST_TEST(!solved(result));
    BOOST_TEST(std::isinf(result.residual));
    BOOST_TEST(std::isinf(natural_residual(VectorXd::Ones(9), z)));
  }
}

BOOST_AUTO_TEST_CASE(a_solution_as_a_guess_ends_at_once) {
  for (const auto& [name, solve] : solvers()) {
    if (std::string(name) == "Lemke") continue;
    const LcpResult result = solve(chain(400), {.guess = VectorXd::Ones(400)});
    BOOST_TEST(solved(result), name);
    BOOST_TEST(result.iterations <= 1, name);
  }
}

BOOST_AUTO_TEST_CASE(a_matrix_that_is_only_applied) {
  int products = 0;
  const LcpOperator applied{[&](const VectorXd& z) -> VectorXd {
                              ++products;
                              return chain_matrix(50) * z;
                            },
                            chain(50).offset};
  const LcpResult result = matrix_free_barzilai_borwein(applied);
  BOOST_TEST(solved(result));
  BOOST_TEST(result.iterations == products);
  BOOST_TEST(largest(result.z - VectorXd::Ones(50)) < 1e-5);
}

}  // namespace stokesbook::test
