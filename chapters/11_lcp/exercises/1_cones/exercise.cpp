// Exercise 11.1: the cones of two contacts, and those of Murty's matrix.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// Task 1: how many sets of contacts solve w = q + M z.
int count_solutions(const Matrix2d& matrix, const Vector2d& offset) {
  //@ starter
  not_done(matrix, offset);  // your code instead of this line
  //@ solution
  int count = offset.minCoeff() >= 0.0 ? 1 : 0;
  for (int i = 0; i < 2; ++i) {
    const double z = -offset[i] / matrix(i, i), w = offset[1 - i] + matrix(1 - i, i) * z;
    if (matrix(i, i) != 0.0 && z >= 0.0 && w >= 0.0) ++count;
  }
  if (matrix.determinant() != 0.0 && (-matrix.inverse() * offset).minCoeff() >= 0.0) ++count;
  return count;
  //@ wrong blind: the gaps of the other contacts have to be open
  int count = offset.minCoeff() >= 0.0 ? 1 : 0;
  for (int i = 0; i < 2; ++i) {
    if (matrix(i, i) != 0.0 && -offset[i] / matrix(i, i) >= 0.0) ++count;
  }
  if (matrix.determinant() != 0.0 && (-matrix.inverse() * offset).minCoeff() >= 0.0) ++count;
  return count;
  //@ wrong always_pushing: the empty set is missing
  int count = 0;
  for (int i = 0; i < 2; ++i) {
    const double z = -offset[i] / matrix(i, i), w = offset[1 - i] + matrix(1 - i, i) * z;
    if (matrix(i, i) != 0.0 && z >= 0.0 && w >= 0.0) ++count;
  }
  if (matrix.determinant() != 0.0 && (-matrix.inverse() * offset).minCoeff() >= 0.0) ++count;
  return count;
  //@ end
}

// Task 2: whether v proves that there is no solution.
bool proves_no_solution(const VectorXd& v, const MatrixXd& matrix, const VectorXd& offset) {
  //@ starter
  not_done(v, matrix, offset);  // your code instead of this line
  //@ solution
  return v.minCoeff() >= 0.0 && (matrix.transpose() * v).maxCoeff() <= 0.0 && offset.dot(v) < 0.0;
  //@ wrong untransposed: it is the transpose of M that v meets
  return v.minCoeff() >= 0.0 && (matrix * v).maxCoeff() <= 0.0 && offset.dot(v) < 0.0;
  //@ end
}

// Task 3: y_1 ... y_m.
VectorXd folds(int m, double s, double eps) {
  //@ starter
  not_done(m, s, eps);  // your code instead of this line
  //@ solution
  VectorXd y(m);
  double forces = 0.0;
  for (Index i = 0; i < m; ++i) {
    y[i] = s + std::pow(eps, static_cast<double>(i + 1)) + 2.0 * forces;
    forces += std::max(0.0, -y[i]);
  }
  return y;
  //@ wrong neighbours: all earlier forces count, not the last one
  VectorXd y(m);
  double force = 0.0;
  for (Index i = 0; i < m; ++i) {
    y[i] = s + std::pow(eps, static_cast<double>(i + 1)) + 2.0 * force;
    force = std::max(0.0, -y[i]);
  }
  return y;
  //@ end
}
