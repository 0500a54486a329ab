#pragma once

#include <Eigen/Core>

#include "closure/problem.hpp"

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// The rigid motions of an inner component as matrices: U_1, U_2 and a omega, for its radius of
/// gyration a, so that all three are velocities.
struct RigidModeMatrices {
  double radius = 0.0;         ///< a, length
  Eigen::MatrixXd modes;       ///< K, 2N x 3: motions to velocities at the nodes, interleaved
  Eigen::MatrixXd projection;  ///< Pi, 3 x 2N: densities to motions, P = K Pi
};

/// Assembles the rigid motions of a component.
///
/// @param  component  with N nodes, inner
/// @return            its matrices
/// @par Cost          O(N^2)
RigidModeMatrices rigid_mode_matrices(const Component& component);

/// @}

}  // namespace stokesbook
