#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// Computes the least change of motions that makes a computed mobility positive definite.
///
/// Loads do positive work on the motions that they cause: the matrix \f$ F^TV \f$ is symmetric and
/// positive definite. Errors of the motions may make the computed matrix indefinite if some loads
/// hardly move anything, such as the forces across three gaps around trapped fluid; the
/// complementarity problem may then have no solution. All eigenvalues of the symmetric part, scaled
/// to a unit diagonal, are increased to the modulus of the most negative one, which is a lower
/// bound for the errors.
/// @param  loads  F, D x m, in units in which all components of a load are comparable
/// @param  works  \f$ F^TV \f$, m x m, of the motions V under these loads
/// @return        change of V, D x m; zero if the matrix is positive definite, or if a diagonal
///                entry is not positive, which no small change repairs
/// @par Cost      a Cholesky factorisation of an m x m matrix; eigenvectors if it fails
Eigen::MatrixXd definite_correction(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& works);

}  // namespace stokesbook
