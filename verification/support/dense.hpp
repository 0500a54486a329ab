#pragma once

#include <Eigen/Core>

namespace stokesbook::test {

// Dense linear algebra of whole systems. It lives in one translation unit, because Eigen's
// decompositions take tens of seconds to compile.

/// By LU with partial pivoting.
Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// Largest first; each to a few hundred rounding units of the largest.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// |A| |A^-1| in the 2-norm, to a relative error of the condition number in rounding units: the
/// least singular value itself would be worse.
double condition_number(const Eigen::MatrixXd& matrix);

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Of a symmetric matrix, of which only the lower half is read; smallest first.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// Argument of the least |matrix x - rhs|, for full column rank.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs);

/// The orthogonal factor of matrix = Q R.
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix);

}  // namespace stokesbook::test
