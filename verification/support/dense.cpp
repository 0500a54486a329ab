#include "support/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace stokesbook::test {

Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return matrix.partialPivLu().solve(rhs);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.partialPivLu().inverse();
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return Eigen::BDCSVD<Eigen::MatrixXd>(matrix).singularValues();
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
  return matrix.colPivHouseholderQr().solve(rhs);
}

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix) {
  return matrix.householderQr().householderQ();
}

}  // namespace stokesbook::test
