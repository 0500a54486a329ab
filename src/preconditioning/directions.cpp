// Chooses the directions in which a group of components is coupled to others (chapter 13, section
// "A tree of groups"): eigenvectors of Gram matrices of its couplings.
#include "preconditioning/directions.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXf;

namespace {

// Weight of expansions beside near blocks when directions are chosen, where all far groups count
// together.
constexpr float far_weight = 3.0F;

}  // namespace

void add_products(const MatrixXf& columns, MatrixXf& gram) {
  if (columns.cols() > 0) gram.selfadjointView<Eigen::Lower>().rankUpdate(columns);
}

void add_far_couplings(const MatrixXf& expansions, const FarField& far_field, MatrixXf& gram) {
  const VectorXf weights = far_weight * far_field.weights();
  add_products(expansions * weights.asDiagonal(), gram);
}

// A Cholesky factorisation whose pivots are the largest diagonal entries.
MatrixXf factor_of(double tau, MatrixXf gram) {
  const auto bound = static_cast<float>(tau * tau);
  constexpr float remainder = 0.16F;  // largest diagonal entry that is left, over tau^2
  gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
  const Index n = gram.rows();
  VectorXf diagonal = gram.diagonal();
  MatrixXf factor(n, n);
  Index rank = 0;
  for (; rank < n; ++rank) {
    Index pivot = 0;
    const float largest = diagonal.maxCoeff(&pivot);
    if (!(largest > remainder * bound)) break;
    auto column = factor.col(rank);
    column = gram.col(pivot);
    column.noalias() -= factor.leftCols(rank) * factor.row(pivot).head(rank).transpose();
    column /= std::sqrt(largest);
    diagonal -= column.cwiseAbs2();
    diagonal[pivot] = 0.0F;
  }
  factor.conservativeResize(Eigen::NoChange, rank);
  return factor;
}

MatrixXf basis_above(double tau, const MatrixXf& factor) {
  if (factor.cols() == 0) return {factor.rows(), 0};
  // In double precision, because all libraries share the compiled solver.
  const MatrixXd inner = MatrixXf(factor.transpose() * factor).cast<double>();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(inner);
  const Index count = (solver.eigenvalues().array() > tau * tau).count();
  if (count == 0) return {factor.rows(), 0};
  const MatrixXf vectors = solver.eigenvectors().rightCols(count).cast<float>();
  MatrixXf basis = factor * vectors;
  basis.colwise().normalize();
  // The columns are orthogonal but for rounding errors, which a step of Newton and Schulz squares.
  MatrixXf correction = -0.5F * (basis.transpose() * basis);
  correction.diagonal().array() += 1.5F;
  return basis * correction;
}

MatrixXf basis_above(double tau, const MatrixXf& factor, const MatrixXf& other) {
  return basis_above(tau, factor - other * (other.transpose() * factor));
}

MatrixXf side_by_side(const MatrixXf& left, const MatrixXf& right) {
  MatrixXf both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

}  // namespace stokesbook
