#include "support/spectra.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "support/dense.hpp"

namespace stokesbook::test {

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

Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  return matrix.selfadjointView<Eigen::Lower>().eigenvalues();
}

}  // namespace stokesbook::test
