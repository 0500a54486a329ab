// Checks that GMRES returns the solution of an LU factorisation, that its history holds true
// residuals of the unpreconditioned system, and that it takes no more iterations than theory
// allows.
#include "krylov/gmres.hpp"

#include <cmath>

#include <boost/test/unit_test.hpp>

#include "krylov/matrices.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::map_of;
using test::normal_matrix;
using test::orthogonal_matrix;
using test::well_conditioned_matrix;

namespace {

double residual(const MatrixXd& a, const VectorXd& x, const VectorXd& b) {
  return (b - a * x).norm() / b.norm();
}

// Returns the least residual over the Krylov space K_k(A, b) (05.2), by a QR factorisation of its
// vectors.
double least_residual(const MatrixXd& a, const VectorXd& b, Index k) {
  MatrixXd krylov(b.size(), k);
  krylov.col(0) = b.normalized();
  for (Index j = 1; j < k; ++j) krylov.col(j) = (a * krylov.col(j - 1)).normalized();
  const MatrixXd image = a * krylov;
  return residual(a, krylov * test::least_squares(image, b), b);
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_systems_as_by_lu) {
  for (Index n : {1, 2, 5, 40, 150}) {
    const MatrixXd a = well_conditioned_matrix(n, 1);
    const VectorXd b = normal_matrix(n, 1, 2);
    const GmresResult result = gmres(map_of(a), {}, b, {1e-14, 500});
    BOOST_TEST(result.converged);
    BOOST_TEST(result.iterations <= n);
    BOOST_TEST((result.solution - test::solve(a, b)).norm() < 1e-13 * b.norm());
  }
}

BOOST_AUTO_TEST_CASE(the_history_is_the_true_residual_and_never_rises) {
  const MatrixXd a = well_conditioned_matrix(80, 3);
  const VectorXd b = normal_matrix(80, 1, 4);
  const GmresResult full = gmres(map_of(a), {}, b, {1e-12, 500});
  BOOST_TEST(full.history.size() == static_cast<std::size_t>(full.iterations) + 1);
  BOOST_TEST(full.history.front() == 1.0);
  BOOST_TEST(full.history.back() <= 1e-12);
  for (std::size_t k = 1; k < full.history.size(); ++k) {
    BOOST_TEST(full.history[k] <= full.history[k - 1]);
    const GmresResult cut = gmres(map_of(a), {}, b, {1e-12, static_cast<int>(k)});
    BOOST_TEST(std::abs(residual(a, cut.solution, b) - full.history[k]) < 1e-14);
    BOOST_TEST(std::abs(cut.residual - full.history[k]) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(every_residual_is_the_least_of_its_krylov_space) {
  const MatrixXd a = well_conditioned_matrix(60, 5);
  const VectorXd b = normal_matrix(60, 1, 6);
  const GmresResult result = gmres(map_of(a), {}, b, {1e-6, 500});
  for (Index k = 1; k <= 8; ++k) {
    BOOST_TEST(std::abs(result.history[static_cast<std::size_t>(k)] - least_residual(a, b, k)) <
               1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_preconditioner_from_the_right_keeps_the_residual) {
  // The rows have very different sizes: a preconditioner from the left would change the residual
  // (05.9).
  const Index n = 60;
  const VectorXd scale =
      VectorXd::LinSpaced(n, 0.0, 3.0).unaryExpr([](double e) { return std::pow(10.0, e); });
  const MatrixXd a = scale.asDiagonal() * well_conditioned_matrix(n, 7);
  const VectorXd b = normal_matrix(n, 1, 8);
  const LinearMap precondition = [&](const VectorXd& v) -> VectorXd {
    return v.cwiseQuotient(scale);
  };
  const GmresResult result = gmres(map_of(a), precondition, b, {1e-12, 500});
  BOOST_TEST(result.converged);
  BOOST_TEST(result.residual < 2e-12);
  BOOST_TEST(std::abs(residual(a, result.solution, b) - result.residual) < 1e-14);
  for (int k : {1, 5, 10}) {
    const GmresResult cut = gmres(map_of(a), precondition, b, {1e-12, k});
    BOOST_TEST(std::abs(residual(a, cut.solution, b) - cut.history.back()) < 1e-13);
  }
  BOOST_TEST((result.solution - test::solve(a, b)).norm() < 1e-11 * result.solution.norm());
}

BOOST_AUTO_TEST_CASE(the_inverse_as_preconditioner_takes_one_iteration) {
  const MatrixXd a = well_conditioned_matrix(30, 9);
  const VectorXd b = normal_matrix(30, 1, 10);
  const GmresResult result = gmres(map_of(a), map_of(test::inverse(a)), b, {1e-12, 500});
  BOOST_TEST(result.converged);
  BOOST_TEST(result.iterations == 1);
}

BOOST_AUTO_TEST_CASE(as_many_iterations_as_distinct_eigenvalues) {
  // The matrix is diagonalisable with 2, 4 and 7 distinct eigenvalues. The number of distinct
  // eigenvalues is the degree of the minimal polynomial.
  const Index n = 84;
  const MatrixXd modes = orthogonal_matrix(n, 11) + 0.2 / 9.0 * normal_matrix(n, n, 12);
  const VectorXd b = normal_matrix(n, 1, 13);
  for (Index distinct : {2, 4, 7}) {
    VectorXd eigenvalues(n);
    for (Index i = 0; i < n; ++i) eigenvalues[i] = -0.5 - 0.1 * static_cast<double>(i % distinct);
    const MatrixXd a = modes * eigenvalues.asDiagonal() * test::inverse(modes);
    const GmresResult result = gmres(map_of(a), {}, b, {1e-12, 500});
    BOOST_TEST(result.converged);
    BOOST_TEST(result.iterations == distinct);
  }
}

BOOST_AUTO_TEST_CASE(the_unit_of_the_data_does_not_matter) {
  const MatrixXd a = well_conditioned_matrix(50, 14);
  const VectorXd b = normal_matrix(50, 1, 15);
  const GmresResult one = gmres(map_of(a), {}, b, {1e-10, 500});
  for (double scale : {1e-30, 1e30}) {
    const GmresResult other = gmres(map_of(a), {}, scale * b, {1e-10, 500});
    BOOST_TEST(other.iterations == one.iterations);
    BOOST_TEST((other.solution / scale - one.solution).norm() < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(a_guess_saves_iterations_but_not_digits) {
  const MatrixXd a = well_conditioned_matrix(80, 16);
  const VectorXd b = normal_matrix(80, 1, 17), exact = test::solve(a, b);
  int applications = 0;
  const LinearMap count = [&](const VectorXd& v) -> VectorXd {
    ++applications;
    return a * v;
  };
  const int cold = gmres(map_of(a), {}, b, {1e-10, 500}).iterations;
  int before = cold;
  for (double error : {1e-2, 1e-4, 1e-8}) {
    applications = 0;
    const VectorXd guess = exact + error * exact.norm() * normal_matrix(80, 1, 18).normalized();
    const GmresResult result = gmres(count, {}, b, {1e-10, 500}, guess);
    BOOST_TEST(result.converged);
    BOOST_TEST(residual(a, result.solution, b) <= 1.001e-10);
    BOOST_TEST(result.history.front() == residual(a, guess, b));
    BOOST_TEST(result.iterations < before);
    BOOST_TEST(result.applications == applications);
    before = result.iterations;
  }
  BOOST_TEST(gmres(map_of(a), {}, b, {1e-10, 500}, exact).iterations == 0);
}

BOOST_AUTO_TEST_CASE(with_a_known_norm_the_residual_takes_no_product_unless_rounding_matters) {
  const MatrixXd a = well_conditioned_matrix(60, 21);
  const VectorXd b = normal_matrix(60, 1, 22);
  for (const double tolerance : {1e-2, 1e-6, 1e-12}) {
    for (const double norm : {a.norm(), 1e12 * a.norm()}) {
      const GmresResult result = gmres(map_of(a), {}, b, {tolerance, 500, norm});
      BOOST_TEST(result.converged);
      const bool matters = tolerance < 1e-9 || norm > 1e9;
      BOOST_TEST(result.applications == result.iterations + (matters ? 1 : 0));
      BOOST_TEST(std::abs(result.residual - residual(a, result.solution, b)) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_guess_that_is_worse_than_nothing_is_ignored) {
  const MatrixXd a = well_conditioned_matrix(30, 19);
  const VectorXd b = normal_matrix(30, 1, 20);
  const GmresResult cold = gmres(map_of(a), {}, b, {1e-10, 500});
  for (const VectorXd& guess :
       {VectorXd{100.0 * b}, VectorXd{VectorXd::Constant(30, std::nan(""))}}) {
    const GmresResult result = gmres(map_of(a), {}, b, {1e-10, 500}, guess);
    BOOST_TEST((result.solution - cold.solution).norm() == 0.0);
    BOOST_TEST(result.applications == cold.applications + 1);
  }
}
