// Corrects a computed mobility that is not positive definite (chapter 12, section "Contact").
#include "suspension/contact/definite_correction.hpp"

#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

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
  // The least V' with F^T V' = change: F (F^T F)^+ change, where loads may depend on each other.
  const MatrixXd gram = loads.transpose() * loads;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> of_gram(gram);
  const VectorXd& squares = of_gram.eigenvalues();
  const double zero =
      std::numeric_limits<double>::epsilon() * static_cast<double>(m) * squares.maxCoeff();
  const VectorXd inverse = (squares.array() > zero).select(squares.cwiseInverse(), 0.0);
  MatrixXd along = of_gram.eigenvectors().transpose() * change;
  along = inverse.asDiagonal() * along;
  return loads * (of_gram.eigenvectors() * along);
}

}  // namespace stokesbook
