#pragma once

#include <Eigen/Core>

#include "closure/closure.hpp"

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

/// Evaluates what a closure adds to the velocities for the rigid motions of a component, C K: it
/// depends on a density by these alone.
///
/// @param  closure  of a problem with n nodes
/// @param  modes    K of the component
/// @param  first    position of its first node in all
/// @param  n        nodes in all
/// @return          2n x 3, dimensionless
/// @par Cost        three times that of Closure::velocity()
Eigen::MatrixXd closed_modes(const Closure& closure, const Eigen::MatrixXd& modes,
                             Eigen::Index first, Eigen::Index n);

/// @}

}  // namespace stokesbook
