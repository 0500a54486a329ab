#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Finds what makes a computed mobility positive definite.
///
/// Loads do work on the motions that they cause: F^T V is symmetric and positive definite. Motions
/// that are known up to an error make it so up to an error. That matters where loads hardly move
/// anything, such as the forces across three gaps around trapped fluid: what these resolve may then
/// have no solution. A negative eigenvalue of the symmetric part, after scaling to a unit diagonal,
/// tells how large errors are at least. Here all below its size are raised to it, by the least
/// change of the motions that does so.
///
/// @param  loads  F, D x m, in such units that a component of one counts as one of another
/// @param  works  F^T V, m x m, of the motions V under them
/// @return        D x m to be added to V; zero where nothing is to be raised, or where a load moves
///                its own point backwards: then V answers nothing
/// @par Cost      a Cholesky factorisation of an m x m matrix; eigenvectors where it fails
Eigen::MatrixXd definite_correction(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& works);

/// @}

}  // namespace stokesbook
