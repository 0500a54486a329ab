// Solves small dense systems by LU with partial pivoting, by least squares and by QR. The solutions
// are the reference for iterative and fast methods. Eigen's decompositions take long to compile, so
// they are compiled only here.
#include "support/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace stokesbook::test {

Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return matrix.partialPivLu().solve(rhs);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.partialPivLu().inverse();
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return matrix.completeOrthogonalDecomposition().solve(rhs);
}

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix) {
  return matrix.householderQr().householderQ() *
         Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
}

}  // namespace stokesbook::test
