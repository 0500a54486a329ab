#pragma once

#include <Eigen/Core>

namespace stokesbook::test {

/// Largest first; each to a few hundred rounding units of the largest.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// |A| |A^-1| in the 2-norm, to a relative error of the condition number in rounding units: the
/// least singular value itself would be worse.
double condition_number(const Eigen::MatrixXd& matrix);

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Eigenvalues, and the eigenvectors as columns in the same order.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};

Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix);

/// Of a symmetric matrix, of which only the lower half is read; smallest first.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace stokesbook::test
