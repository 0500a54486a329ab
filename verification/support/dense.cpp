// Solves small dense systems by LU with partial pivoting, by least squares and by QR. The solutions
// are the reference for iterative and fast methods. Eigen's QR takes long to compile, so this
// file uses GSL's.
#include "support/dense.hpp"

#include <algorithm>

#include <Eigen/LU>
#include <gsl/gsl_linalg.h>

#include "support/gsl_matrix.hpp"

namespace stokesbook::test {

Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return matrix.partialPivLu().solve(rhs);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.partialPivLu().inverse();
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  RowMajorMatrix factors = matrix;
  gsl_matrix_view a = gsl_view(factors);
  const Eigen::Index rank_at_most = std::min(matrix.rows(), matrix.cols());
  Eigen::VectorXd b = rhs, x(matrix.cols()), residual(matrix.rows()), work(matrix.cols()),
                  left(rank_at_most), right(rank_at_most);
  gsl_vector_view tau_left = gsl_view(left), tau_right = gsl_view(right), scratch = gsl_view(work),
                  rhs_view = gsl_view(b), solution = gsl_view(x), rest = gsl_view(residual);
  gsl_permutation* order = gsl_permutation_alloc(static_cast<std::size_t>(matrix.cols()));
  std::size_t rank = 0;
  gsl_linalg_COD_decomp(&a.matrix, &tau_left.vector, &tau_right.vector, order, &rank,
                        &scratch.vector);
  gsl_linalg_COD_lssolve(&a.matrix, &tau_left.vector, &tau_right.vector, order, rank,
                         &rhs_view.vector, &solution.vector, &rest.vector);
  gsl_permutation_free(order);
  return x;
}

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix) {
  RowMajorMatrix factors = matrix;
  gsl_matrix_view a = gsl_view(factors);
  Eigen::VectorXd scalars(std::min(matrix.rows(), matrix.cols()));
  gsl_vector_view tau = gsl_view(scalars);
  gsl_linalg_QR_decomp(&a.matrix, &tau.vector);
  Eigen::MatrixXd q = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  for (Eigen::Index j = 0; j < q.cols(); ++j) {
    auto column = q.col(j);
    gsl_vector_view v = gsl_view(column);
    gsl_linalg_QR_Qvec(&a.matrix, &tau.vector, &v.vector);
  }
  return q;
}

}  // namespace stokesbook::test
