// Increases the negative and small eigenvalues of a computed mobility matrix (chapter 12).
#include "suspension/contact/definite_correction.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace stokesbook {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd definite_correction(const MatrixXd& loads, const MatrixXd& works) {
  const MatrixXd none = MatrixXd::Zero(loads.rows(), loads.cols());
  const auto m = loads.cols();
  if (m == 0 || !(works.diagonal().minCoeff() > 0.0)) return none;
  const VectorXd scale = works.diagonal().cwiseSqrt();
  const VectorXd unit = scale.cwiseInverse();
  const MatrixXd scaled = unit.asDiagonal() * works * unit.asDiagonal();
  const MatrixXd symmetric = 0.5 * (scaled + scaled.transpose());
  if (symmetric.llt().info() == Eigen::Success) return none;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(symmetric);
  const VectorXd& eigenvalues = modes.eigenvalues();
  const VectorXd increase = (-eigenvalues.minCoeff() - eigenvalues.array()).cwiseMax(0.0);
  const MatrixXd vectors = scale.asDiagonal() * modes.eigenvectors();
  const MatrixXd change = vectors * increase.asDiagonal() * vectors.transpose();
  // The least V' with F^T V' = change.
  const MatrixXd gram = loads.transpose() * loads;
  return loads * gram.completeOrthogonalDecomposition().solve(change);
}

}  // namespace stokesbook
