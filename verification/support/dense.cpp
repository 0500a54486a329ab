#include "support/dense.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace stokesbook::test {

Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return matrix.partialPivLu().solve(rhs);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.partialPivLu().inverse();
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  // They are the eigenvalues >= 0 of (0 A; A^T 0). Eigen's BDCSVD takes 25 s to compile.
  const Eigen::Index rows = matrix.rows(), columns = matrix.cols();
  Eigen::MatrixXd augmented = Eigen::MatrixXd::Zero(rows + columns, rows + columns);
  augmented.bottomLeftCorner(columns, rows) = matrix.transpose();
  return symmetric_eigenvalues(augmented).tail(std::min(rows, columns)).reverse();
}

double condition_number(const Eigen::MatrixXd& matrix) {
  return singular_values(matrix)[0] * singular_values(inverse(matrix))[0];
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) {
  return matrix.eigenvalues();
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  return matrix.selfadjointView<Eigen::Lower>().eigenvalues();
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return matrix.householderQr().solve(rhs);
}

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix) {
  return matrix.householderQr().householderQ();
}

}  // namespace stokesbook::test
