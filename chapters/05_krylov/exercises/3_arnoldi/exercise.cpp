// Exercise 05.3: GMRES from its parts.
#include "chapters/exercise.hpp"

#include <cmath>

#include "krylov/gmres.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using stokesbook::LinearMap;
using stokesbook::exercise::not_done;

// A step of Arnoldi's method: A v_k = column[0] v_1 + ... + column[k-1] v_k + column[k] next.
struct Step {
  VectorXd column;  // k + 1 entries of H
  VectorXd next;    // v_{k+1}
};

// The matrix (cosine, sine; -sine, cosine).
struct Rotation {
  double cosine, sine;
};

// Task 1: the step from the basis v_1, ..., v_k, the columns of a matrix.
Step arnoldi_step(const LinearMap& apply, const MatrixXd& basis) {
  //@ starter
  not_done(apply, basis);  // your code instead of this line
  //@ solution
  const Index k = basis.cols();
  VectorXd w = apply(basis.col(k - 1)), column = VectorXd::Zero(k + 1);
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd overlap = basis.transpose() * w;
    w -= basis * overlap;
    column.head(k) += overlap;
  }
  column[k] = w.norm();
  return {column, w / column[k]};
  //@ wrong one_pass: subtract a second time
  const Index k = basis.cols();
  VectorXd w = apply(basis.col(k - 1)), column(k + 1);
  column.head(k) = basis.transpose() * w;
  w -= basis * column.head(k);
  column[k] = w.norm();
  return {column, w / column[k]};
  //@ wrong one_by_one: subtract a second time
  const Index k = basis.cols();
  VectorXd w = apply(basis.col(k - 1)), column(k + 1);
  for (Index i = 0; i < k; ++i) {
    column[i] = basis.col(i).dot(w);
    w -= column[i] * basis.col(i);
  }
  column[k] = w.norm();
  return {column, w / column[k]};
  //@ wrong overwritten: the second pass gives corrections
  const Index k = basis.cols();
  VectorXd w = apply(basis.col(k - 1)), column(k + 1);
  for (int pass = 0; pass < 2; ++pass) {
    column.head(k) = basis.transpose() * w;
    w -= basis * column.head(k);
  }
  column[k] = w.norm();
  return {column, w / column[k]};
  //@ wrong first_vector: this step multiplies the first basis vector
  const Index k = basis.cols();
  VectorXd w = apply(basis.col(0)), column = VectorXd::Zero(k + 1);
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd overlap = basis.transpose() * w;
    w -= basis * overlap;
    column.head(k) += overlap;
  }
  column[k] = w.norm();
  return {column, w / column[k]};
  //@ wrong unscaled: the next vector has the length 1
  const Index k = basis.cols();
  VectorXd w = apply(basis.col(k - 1)), column = VectorXd::Zero(k + 1);
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd overlap = basis.transpose() * w;
    w -= basis * overlap;
    column.head(k) += overlap;
  }
  column[k] = w.norm();
  return {column, w};
  //@ end
}

// Task 2: the rotation that takes (a, b) to (rho, 0), rho > 0.
Rotation givens(double a, double b) {
  //@ starter
  not_done(a, b);  // your code instead of this line
  //@ solution
  const double rho = std::hypot(a, b);
  return {a / rho, b / rho};
  //@ wrong turned_back: this rotation turns the other way
  const double rho = std::hypot(a, b);
  return {a / rho, -b / rho};
  //@ wrong through_tangent: rho is negative where a is
  const double tangent = b / a, cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  return {cosine, tangent * cosine};
  //@ wrong divided_by_a: a may be zero
  const double tangent = b / a, cosine = std::copysign(1.0, a) / std::hypot(1.0, tangent);
  return {cosine, tangent * cosine};
  //@ end
}

//@ starter
//@ solution
// Lets a rotation act on the rows j and j + 1.
void rotate(MatrixXd& matrix, Index j, const Rotation& rotation) {
  const auto [c, s] = rotation;
  for (Index column = 0; column < matrix.cols(); ++column) {
    const double upper = matrix(j, column), lower = matrix(j + 1, column);
    matrix(j, column) = c * upper + s * lower;
    matrix(j + 1, column) = c * lower - s * upper;
  }
}

// The matrix (H, beta e_1).
MatrixXd with_right_hand_side(const MatrixXd& hessenberg, double beta) {
  MatrixXd system(hessenberg.rows(), hessenberg.rows());
  system << hessenberg, beta * VectorXd::Unit(hessenberg.rows(), 0);
  return system;
}

//@ end
// Task 3: the residuals before the first iteration, and after each iteration; H has k + 1 rows.
VectorXd residual_history(const MatrixXd& hessenberg, double beta) {
  //@ starter
  not_done(hessenberg, beta);  // your code instead of this line
  //@ solution
  const Index k = hessenberg.cols();
  MatrixXd system = with_right_hand_side(hessenberg, beta);
  VectorXd residuals(k + 1);
  residuals[0] = beta;
  for (Index j = 0; j < k; ++j) {
    rotate(system, j, givens(system(j, j), system(j + 1, j)));
    residuals[j + 1] = std::abs(system(j + 1, k));
  }
  return residuals;
  //@ wrong unturned_columns: the earlier rotations act on the new column, too
  const Index k = hessenberg.cols();
  VectorXd residuals(k + 1);
  residuals[0] = beta;
  for (Index j = 0; j < k; ++j) {
    residuals[j + 1] = residuals[j] * givens(hessenberg(j, j), hessenberg(j + 1, j)).sine;
  }
  return residuals;
  //@ wrong tangents: these are the residuals of Galerkin's condition
  const Index k = hessenberg.cols();
  MatrixXd system = with_right_hand_side(hessenberg, beta);
  VectorXd residuals(k + 1);
  residuals[0] = beta;
  for (Index j = 0; j < k; ++j) {
    residuals[j + 1] = std::abs(system(j, k) * system(j + 1, j) / system(j, j));
    rotate(system, j, givens(system(j, j), system(j + 1, j)));
  }
  return residuals;
  //@ wrong relative: these residuals are relative to beta
  const Index k = hessenberg.cols();
  MatrixXd system = with_right_hand_side(hessenberg, 1.0);
  static_cast<void>(beta);
  VectorXd residuals(k + 1);
  residuals[0] = 1.0;
  for (Index j = 0; j < k; ++j) {
    rotate(system, j, givens(system(j, j), system(j + 1, j)));
    residuals[j + 1] = std::abs(system(j + 1, k));
  }
  return residuals;
  //@ wrong signed_entries: a residual is a length
  const Index k = hessenberg.cols();
  MatrixXd system = with_right_hand_side(hessenberg, beta);
  VectorXd residuals(k + 1);
  residuals[0] = beta;
  for (Index j = 0; j < k; ++j) {
    rotate(system, j, givens(system(j, j), system(j + 1, j)));
    residuals[j + 1] = system(j + 1, k);
  }
  return residuals;
  //@ end
}

//@ starter
//@ solution
// V_k and H_k of (05.3).
struct Arnoldi {
  MatrixXd basis, hessenberg;
};

Arnoldi arnoldi(const LinearMap& apply, const VectorXd& b, int k) {
  MatrixXd basis = b / b.norm(), hessenberg = MatrixXd::Zero(k + 1, k);
  for (Index j = 0; j < k; ++j) {
    const Step step = arnoldi_step(apply, basis);
    hessenberg.col(j).head(j + 2) = step.column;
    basis.conservativeResize(Eigen::NoChange, j + 2);
    basis.col(j + 1) = step.next;
  }
  return {basis.leftCols(k), hessenberg};
}

// Makes the matrix (H, beta e_1) triangular.
void triangulate(MatrixXd& system) {
  for (Index j = 0; j + 1 < system.rows(); ++j) {
    rotate(system, j, givens(system(j, j), system(j + 1, j)));
  }
}

// The y that satisfies the first k rows of (R, g), with an upper triangular R.
VectorXd back_substituted(const MatrixXd& system) {
  const Index k = system.cols() - 1;
  VectorXd y = system.col(k).head(k);
  for (Index i = k - 1; i >= 0; --i) {
    for (Index j = i + 1; j < k; ++j) y[i] -= system(i, j) * y[j];
    y[i] /= system(i, i);
  }
  return y;
}

//@ end
// Task 4: the solution of GMRES after k iterations from zero.
VectorXd krylov_solution(const LinearMap& apply, const VectorXd& b, int k) {
  //@ starter
  not_done(apply, b, k);  // your code instead of this line
  //@ solution
  const auto [basis, hessenberg] = arnoldi(apply, b, k);
  MatrixXd system = with_right_hand_side(hessenberg, b.norm());
  triangulate(system);
  return basis * back_substituted(system);
  //@ wrong galerkin: this is the solution by Galerkin's condition
  const auto [basis, hessenberg] = arnoldi(apply, b, k);
  MatrixXd system = with_right_hand_side(hessenberg, b.norm());
  for (Index j = 0; j + 1 < k; ++j) rotate(system, j, givens(system(j, j), system(j + 1, j)));
  return basis * back_substituted(system);
  //@ wrong right_hand_side_at_rest: the rotations act on the right-hand side, too
  const auto [basis, hessenberg] = arnoldi(apply, b, k);
  MatrixXd system = with_right_hand_side(hessenberg, b.norm());
  triangulate(system);
  system.col(k) = b.norm() * VectorXd::Unit(k + 1, 0);
  return basis * back_substituted(system);
  //@ wrong unit_right_hand_side: the right-hand side has the length beta
  const auto [basis, hessenberg] = arnoldi(apply, b, k);
  MatrixXd system = with_right_hand_side(hessenberg, 1.0);
  triangulate(system);
  return basis * back_substituted(system);
  //@ end
}
