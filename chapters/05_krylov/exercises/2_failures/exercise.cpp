// Exercise 05.2: systems on which GMRES fails.
#include "chapters/exercise.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Core>

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

struct System {
  MatrixXd matrix;
  VectorXd rhs;
};

// Last column of the companion matrix with these eigenvalues: c_0, ..., c_{n-1} with
// prod (z - lambda_j) = z^n - c_{n-1} z^{n-1} - ... - c_0. Yours to use.
VectorXd companion_column(const std::vector<double>& eigenvalues) {
  VectorXd polynomial = VectorXd::Unit(static_cast<Index>(eigenvalues.size()) + 1, 0);
  for (const double eigenvalue : eigenvalues) {
    VectorXd times_z = VectorXd::Zero(polynomial.size());
    times_z.tail(polynomial.size() - 1) = polynomial.head(polynomial.size() - 1);
    polynomial = (times_z - eigenvalue * polynomial).eval();
  }
  return -polynomial.head(polynomial.size() - 1);
}

// Task 1: an orthogonal matrix on which GMRES stalls, with the right-hand side (1, 0, ..., 0).
MatrixXd stalling(int n) {
  //@ starter
  not_done(n);  // your code instead of this line
  //@ solution
  MatrixXd matrix = MatrixXd::Zero(n, n);
  for (Index j = 0; j < n; ++j) matrix((j + 1) % n, j) = 1.0;
  return matrix;
  //@ wrong open_chain: the matrix is not orthogonal
  MatrixXd matrix = MatrixXd::Zero(n, n);
  for (Index j = 0; j + 1 < n; ++j) matrix(j + 1, j) = 1.0;
  return matrix;
  //@ wrong mirror: GMRES is done after 2 iterations
  return MatrixXd::Identity(n, n).rowwise().reverse();
  //@ end
}

//@ starter
//@ solution
// b in an orthonormal basis in which b - A x is the tail of b after each iteration.
VectorXd components(const std::vector<double>& residuals) {
  const auto n = static_cast<Index>(residuals.size());
  const Eigen::Map<const VectorXd> before(residuals.data(), n);
  VectorXd after = VectorXd::Zero(n);
  after.head(n - 1) = before.tail(n - 1);
  return (before.cwiseAbs2() - after.cwiseAbs2()).cwiseSqrt();
}

// A b = e_1, A e_1 = e_2, ..., A e_{n-1} = c_0 b + c_1 e_1 + ... + c_{n-1} e_{n-1}.
MatrixXd with_basis(const VectorXd& b, const VectorXd& c) {
  const Index n = b.size();
  MatrixXd matrix = MatrixXd::Zero(n, n);
  matrix.diagonal(-1).head(n - 2).setOnes();
  matrix.col(n - 2) = c[0] * b;
  matrix.col(n - 2).head(n - 1) += c.tail(n - 1);
  matrix.col(n - 1) = (VectorXd::Unit(n, 0) - matrix.leftCols(n - 1) * b.head(n - 1)) / b[n - 1];
  return matrix;
}

//@ end
// Task 2: a system with these eigenvalues and these residuals, relative to the right-hand side:
// residuals[0] = 1 > residuals[1] > ... > residuals[n-1] > 0.
System with_history(const std::vector<double>& eigenvalues, const std::vector<double>& residuals) {
  //@ starter
  not_done(eigenvalues, residuals);  // your code instead of this line
  //@ solution
  const VectorXd b = components(residuals);
  return {with_basis(b, companion_column(eigenvalues)), b};
  //@ wrong plain_differences: the squares of the residuals differ by the squares of the components
  const auto n = static_cast<Index>(residuals.size());
  VectorXd b = Eigen::Map<const VectorXd>(residuals.data(), n);
  b.head(n - 1) -= VectorXd(b.tail(n - 1));
  return {with_basis(b, companion_column(eigenvalues)), b};
  //@ wrong in_unit_vectors: the companion matrix is one in the basis b, e_1, ..., e_{n-1}
  const VectorXd b = components(residuals);
  MatrixXd companion = MatrixXd::Zero(b.size(), b.size());
  companion.diagonal(-1).setOnes();
  companion.col(b.size() - 1) = companion_column(eigenvalues);
  return {companion, b};
  //@ end
}

// Task 3: diagonal of M^-1, for A = 1 and b = (1, 1).
Eigen::Vector2d misleading(double reported) {
  //@ starter
  not_done(reported);  // your code instead of this line
  //@ solution
  return {1.0, std::min(0.5 * reported, 0.1)};
  //@ wrong mild_where_much_is_allowed: the solution is right
  return {std::min(reported, 0.9), 1.0};
  //@ wrong harmless: the solution is right
  return {0.5 * reported, 0.5 * reported};
  //@ wrong too_mild: GMRES does not stop after one iteration
  return {1.0, std::sqrt(reported)};
  //@ end
}
