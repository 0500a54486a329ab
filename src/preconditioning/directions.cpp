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

// Expects both triangles of the Gram matrix. A pivoted Cholesky factorisation L L^T finds the range
// of the matrix first, so that only L^T L is diagonalised.
MatrixXf basis_of(double tau, MatrixXf gram) {
  const Index n = gram.rows();
  const auto bound = static_cast<float>(tau * tau);
  constexpr float remainder = 0.16F;  // largest diagonal entry that is left, over tau^2
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
  gram.resize(0, 0);  // frees the memory, which matters in the largest groups
  if (rank == 0) return {n, 0};
  const auto range = factor.leftCols(rank);
  // In double precision, because all libraries share the compiled solver.
  const MatrixXd inner = MatrixXf(range.transpose() * range).cast<double>();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(inner);
  const Index count = (solver.eigenvalues().array() > bound).count();
  if (count == 0) return {n, 0};
  const MatrixXf vectors = solver.eigenvectors().rightCols(count).cast<float>();
  MatrixXf basis = range * vectors;
  basis.colwise().normalize();
  // The columns are orthogonal but for rounding errors, which a step of Newton and Schulz squares.
  MatrixXf correction = -0.5F * (basis.transpose() * basis);
  correction.diagonal().array() += 1.5F;
  return basis * correction;
}

}  // namespace

void add_products(const MatrixXf& columns, MatrixXf& gram) {
  if (columns.cols() > 0) gram.selfadjointView<Eigen::Lower>().rankUpdate(columns);
}

void add_far_couplings(const MatrixXf& expansions, const FarField& far_field, MatrixXf& gram) {
  const VectorXf weights = far_weight * far_field.weights();
  add_products(expansions * weights.asDiagonal(), gram);
}

MatrixXf basis_above(double tau, MatrixXf gram) {
  gram = MatrixXf(gram.selfadjointView<Eigen::Lower>());
  return basis_of(tau, std::move(gram));
}

MatrixXf basis_above(double tau, MatrixXf gram, const MatrixXf& other) {
  gram = MatrixXf(gram.selfadjointView<Eigen::Lower>());
  gram -= other * (other.transpose() * gram);
  gram -= (gram * other) * other.transpose();
  return basis_of(tau, std::move(gram));
}

MatrixXf side_by_side(const MatrixXf& left, const MatrixXf& right) {
  MatrixXf both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

}  // namespace stokesbook
