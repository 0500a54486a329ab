// Checks that GMRES reports a solution only if it has found the solution: singular systems,
// exhausted iterations, and numbers that are not finite.
#include <limits>
#include <stdexcept>
#include <string>

#include <boost/test/unit_test.hpp>

#include "krylov/gmres.hpp"
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

// Returns a symmetric matrix with the eigenvalues 0 (`kernel` times), 1, 2 and 3.
MatrixXd singular_matrix(const MatrixXd& modes, Index kernel) {
  VectorXd eigenvalues(modes.rows());
  for (Index i = 0; i < modes.rows(); ++i) {
    eigenvalues[i] = i < kernel ? 0.0 : 1.0 + static_cast<double>(i % 3);
  }
  return modes * eigenvalues.asDiagonal() * modes.transpose();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_zero_right_hand_side_has_the_zero_solution) {
  int applications = 0;
  const LinearMap count = [&](const VectorXd& v) {
    ++applications;
    return v;
  };
  const GmresResult result = gmres(count, {}, VectorXd::Zero(7), {1e-10, 500});
  BOOST_TEST(result.converged);
  BOOST_TEST(result.iterations == 0);
  BOOST_TEST(result.residual == 0.0);
  BOOST_TEST((result.solution == VectorXd::Zero(7)));
  BOOST_TEST(applications == 0);
}

BOOST_AUTO_TEST_CASE(a_singular_system_with_compatible_data_is_solved) {
  // The kernel is orthogonal to the range, so the Krylov space has no component in the kernel.
  const MatrixXd a = singular_matrix(orthogonal_matrix(30, 1), 4);
  const VectorXd b = a * normal_matrix(30, 1, 2);
  const GmresResult result = gmres(map_of(a), {}, b, {1e-12, 500});
  BOOST_TEST(result.converged);
  BOOST_TEST(result.iterations == 3);
  BOOST_TEST((a * result.solution - b).norm() < 1e-12 * b.norm());
}

BOOST_AUTO_TEST_CASE(incompatible_data_break_down) {
  // The least residual is the part of b in the kernel. Rounding, however, takes the recurrence
  // beyond the Krylov space, where the computed residual seems to vanish.
  const MatrixXd modes = orthogonal_matrix(30, 1);
  const MatrixXd a = singular_matrix(modes, 4);
  const VectorXd b = a * normal_matrix(30, 1, 2) + modes.col(0);
  for (const double tolerance : {1e-12, 1e-3}) {
    BOOST_CHECK_EXCEPTION(gmres(map_of(a), {}, b, {tolerance, 500, a.norm()}), std::domain_error,
                          [](const std::domain_error& error) {
                            return std::string(error.what()).find("singular") != std::string::npos;
                          });
  }
}

BOOST_AUTO_TEST_CASE(a_breakdown_is_not_taken_for_convergence) {
  // A b = 0: the Krylov space holds b alone, although A (0, 1) = b has solutions.
  MatrixXd nilpotent(2, 2);
  nilpotent << 0.0, 1.0, 0.0, 0.0;
  for (const MatrixXd& a : {nilpotent, MatrixXd::Zero(2, 2).eval()}) {
    BOOST_CHECK_THROW(gmres(map_of(a), {}, VectorXd::Unit(2, 0), {1e-10, 500}), std::domain_error);
  }
}

BOOST_AUTO_TEST_CASE(too_few_iterations_do_not_converge) {
  const MatrixXd a = well_conditioned_matrix(60, 3);
  const VectorXd b = normal_matrix(60, 1, 4);
  const GmresResult result = gmres(map_of(a), {}, b, {1e-12, 5});
  BOOST_TEST(!result.converged);
  BOOST_TEST(result.iterations == 5);
  BOOST_TEST(result.history.size() == 6u);
  BOOST_TEST(result.history.back() > 1e-12);
  BOOST_TEST(std::abs((b - a * result.solution).norm() / b.norm() - result.history.back()) < 1e-14);
}

BOOST_AUTO_TEST_CASE(more_iterations_than_the_first_basis_holds) {
  // For a cyclic shift, the residual does not decrease until the last of n iterations.
  for (Index n : {31, 32, 33, 70}) {
    const LinearMap shift = [](const VectorXd& v) -> VectorXd {
      VectorXd shifted(v.size());
      shifted << v.tail(v.size() - 1), v.head(1);
      return shifted;
    };
    const GmresResult result = gmres(shift, {}, VectorXd::Unit(n, 0), {1e-12, 500});
    BOOST_TEST(result.converged);
    BOOST_TEST(result.iterations == n);
    BOOST_TEST(result.history[static_cast<std::size_t>(n - 1)] == 1.0);
    BOOST_TEST((result.solution - VectorXd::Unit(n, 1)).norm() < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(iterations_beyond_the_exact_solution_do_no_harm) {
  // No residual meets a tolerance of zero. After four iterations the Krylov space grows only by
  // rounding errors.
  const MatrixXd modes = orthogonal_matrix(40, 5);
  VectorXd eigenvalues(40);
  for (Index i = 0; i < 40; ++i) eigenvalues[i] = 1.0 + static_cast<double>(i % 4);
  const MatrixXd a = modes * eigenvalues.asDiagonal() * modes.transpose();
  const GmresResult result = gmres(map_of(a), {}, normal_matrix(40, 1, 6), {0.0, 500});
  BOOST_TEST(!result.converged);
  BOOST_TEST(result.residual < 1e-14);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_throw) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : {nan, infinity}) {
    VectorXd b = VectorXd::Ones(4);
    b[2] = bad;
    BOOST_CHECK_THROW(gmres(map_of(MatrixXd::Identity(4, 4)), {}, b, {1e-10, 500}),
                      std::domain_error);
    // The second application returns a number that is not finite, so the message must contain the
    // number of this iteration.
    int applications = 0;
    const LinearMap spoilt = [&](const VectorXd& v) -> VectorXd {
      VectorXd w = v + v.reverse() + VectorXd::LinSpaced(4, 0.0, 1.0);
      if (++applications == 2) w[1] = bad;
      return w;
    };
    BOOST_CHECK_EXCEPTION(gmres(spoilt, {}, VectorXd::Unit(4, 0), {1e-10, 500}), std::domain_error,
                          [](const std::domain_error& error) {
                            return std::string(error.what()).find("iteration 2") !=
                                   std::string::npos;
                          });
  }
}
