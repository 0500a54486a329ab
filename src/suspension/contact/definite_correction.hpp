#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// Computes the least change of motions that makes a computed mobility positive definite.
///
/// Loads do positive work on the motions that they cause: the matrix \f$ F^TV \f$ is symmetric and
/// positive definite. Errors of the motions may make the computed matrix indefinite if some loads
/// hardly move anything, such as the forces across three gaps around trapped fluid; the
/// complementarity problem may then have no solution. A negative eigenvalue of the symmetric part,
/// after a scaling to a unit diagonal, is a lower bound for the errors. All eigenvalues below its
/// modulus are increased to its modulus.
///
/// @param  loads  F, D x m, in units in which all components of a load are comparable
/// @param  works  \f$ F^TV \f$, m x m, of the motions V under these loads
/// @return        change of V, D x m; zero if the matrix is positive definite, or if a diagonal
///                entry is not positive, which no small change repairs
/// @par Cost      a Cholesky factorisation of an m x m matrix; eigenvectors if it fails
Eigen::MatrixXd definite_correction(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& works);

}  // namespace stokesbook
