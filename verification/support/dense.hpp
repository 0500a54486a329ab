#pragma once

#include <Eigen/Core>

namespace stokesbook::test {

// Dense systems. Eigen's decompositions take many seconds to compile: they are compiled here, once.

/// By LU with partial pivoting.
Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// Returns the x for which |matrix x - rhs| is least; if there are several, the shortest.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs);

/// The orthogonal factor of matrix = Q R, with as many columns as the matrix.
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix);

}  // namespace stokesbook::test
