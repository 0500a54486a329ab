#pragma once

#include <Eigen/Core>

namespace stokesbook::test {

// This header declares functions for dense linear algebra. Decompositions take long to compile, so
// they are compiled once, in dense.cpp, or taken from GSL.

/// Solves matrix x = rhs by LU factorisation with partial pivoting.
Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// Returns the x that minimises |matrix x - rhs|; if there are several, the one of least norm. The
/// matrix has at least as many rows as columns.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs);

/// Returns the orthogonal factor Q of matrix = Q R, with as many columns as the matrix.
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix);

}  // namespace stokesbook::test
