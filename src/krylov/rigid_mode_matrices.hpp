#pragma once

#include <Eigen/Core>

#include "closure/closure.hpp"

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// The rigid motions of an inner component as matrices.
///
/// A motion consists of U_1, U_2 and a omega with the component's radius of gyration a, so that all
/// three numbers are velocities.
struct RigidModeMatrices {
  double radius = 0.0;         ///< a, length
  Eigen::MatrixXd modes;       ///< K, 2N x 3: maps motions to velocities at the nodes, interleaved
  Eigen::MatrixXd projection;  ///< Pi, 3 x 2N: maps densities to motions, P = K Pi
};

/// Assembles the rigid motions of an inner component, by O(N^2) operations for N nodes.
RigidModeMatrices rigid_mode_matrices(const Component& component);

/// Evaluates C K, the velocities that a closure C adds for the rigid motions of a component.
///
/// The closure depends on a density only through the rigid motions in the density.
/// @param  modes  K of the component
/// @param  first  position of the component's first node among all nodes
/// @param  n      number of all nodes
/// @return        2n x 3, dimensionless
/// @par Cost      three times that of Closure::velocity()
Eigen::MatrixXd closed_modes(const Closure& closure, const Eigen::MatrixXd& modes,
                             Eigen::Index first, Eigen::Index n);

/// @}

}  // namespace stokesbook
