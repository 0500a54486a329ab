// Tests the definite correction of computed contact mobilities: indefinite ones become definite,
// definite ones stay as they are (chapter 12).

#include "suspension/contact/definite_correction.hpp"

#include <random>

#include <boost/test/unit_test.hpp>

#include "scaled_eigenvalues.hpp"
#include "support/dense.hpp"

namespace stokesbook::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> number;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return number(engine); });
}

// Models a mobility of 12 degrees of freedom and five loads whose sum causes almost no motion.
struct Trapped {
  MatrixXd loads = random_matrix(12, 5, 1);
  MatrixXd velocities;

  Trapped() {
    const MatrixXd factor = random_matrix(12, 12, 2);
    const VectorXd sum = loads.rowwise().sum();
    const MatrixXd others =
        MatrixXd::Identity(12, 12) - (1.0 - 1e-3) * sum * sum.transpose() / sum.squaredNorm();
    const MatrixXd root = others * factor;  // of the mobility
    velocities = root * (root.transpose() * loads);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(exact_mobilities_are_left_alone) {
  const Trapped exact;
  const MatrixXd works = exact.loads.transpose() * exact.velocities;
  BOOST_TEST(scaled_eigenvalues(works)[0] > 0.0);
  BOOST_TEST(scaled_eigenvalues(works)[0] < 1e-5);
  BOOST_TEST(definite_correction(exact.loads, works).norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(errors_that_make_mobilities_indefinite_are_made_up_for) {
  const Trapped exact;
  const MatrixXd basis = orthogonal_factor(exact.loads);
  int indefinite = 0;
  for (unsigned seed = 10; seed < 30; ++seed) {
    const MatrixXd error = 1e-2 * random_matrix(12, 5, seed);
    const MatrixXd works = exact.loads.transpose() * (exact.velocities + error);
    const MatrixXd correction = definite_correction(exact.loads, works);
    const MatrixXd change = exact.loads.transpose() * correction;
    indefinite += scaled_eigenvalues(works)[0] < 0.0 ? 1 : 0;
    BOOST_TEST(scaled_eigenvalues(works + change)[0] > 0.0);
    BOOST_TEST(change.norm() < 3.0 * (exact.loads.transpose() * error).norm());
    // The correction has the smallest motions possible: its columns lie in the span of the loads.
    const MatrixXd along = basis * (basis.transpose() * correction);
    BOOST_TEST((along - correction).norm() <= 1e-12 * correction.norm());
  }
  BOOST_TEST(indefinite >= 5);
}

BOOST_AUTO_TEST_CASE(answers_that_move_backwards_are_left_alone) {
  Trapped wrong;
  wrong.velocities.col(2) *= -1.0;
  const MatrixXd works = wrong.loads.transpose() * wrong.velocities;
  BOOST_TEST(definite_correction(wrong.loads, works).norm() == 0.0);
}

}  // namespace stokesbook::test
