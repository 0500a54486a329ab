#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/scene.hpp"

namespace stokesbook {

/// The linear relation between motions and loads of N free bodies, in a fluid that all other
/// components and the background leave at rest.
///
/// Motions are ordered as to_state() orders them, bodies in the scene's order: two components of
/// the velocity, in length / time, and the angular velocity, in 1 / time. Loads have the same
/// order: two components of the force, in force / length, and the torque, in force. Loads act on
/// the fluid, and torques about the position of a body. Both matrices are symmetric by Lorentz'
/// reciprocal theorem, and positive definite.
struct HydrodynamicMatrices {
  Eigen::MatrixXd resistance;            ///< R, 3N x 3N: loads = R motions
  Eigen::MatrixXd mobility;              ///< M, 3N x 3N: motions = M loads
  std::vector<std::size_t> bodies = {};  ///< numbers of the free bodies in the scene
};

/// Computes both matrices of the free bodies of a scene at its start, each by 3N solves of its own:
/// the columns of M under unit loads, those of R with all free bodies held at unit motions. One
/// solver computes all columns of M, and another one the columns of R for each kind of motion.
///
/// Held bodies and walls are at rest. The flow and the loads of the scene have no effect.
/// @throws SolverError as SuspensionSolver::solve() does; and when the scene has no free body, or
///                when its fluid is unbounded and has neither gauge length nor held component: a
///                single force would then cause infinite velocities (Stokes' paradox)
/// @par Accuracy  each column to solver.tolerance, relative to the velocities of its problem,
/// @ref claim_12_3
/// @par Cost      6N solves
HydrodynamicMatrices hydrodynamic_matrices(const Scene& scene);

/// The properties that both matrices have up to errors, each as its largest violation. Entries are
/// divided by the roots of the diagonal entries of their row and column.
struct MatrixErrors {
  double resistance_asymmetry;  ///< of R - R^T
  double mobility_asymmetry;    ///< of M - M^T
  double inverse_error;         ///< of R M - I
};

/// Measures how far the matrices are from being symmetric, and inverse to each other.
MatrixErrors matrix_errors(const HydrodynamicMatrices& matrices);

/// Writes the resistance matrix as `resistance.csv`: columns `ux0,uy0,omega0,...` and rows
/// `fx0,fy0,torque0,...`, which end in the numbers of the bodies.
std::string resistance_table(const HydrodynamicMatrices& matrices);

/// Writes the mobility matrix as `mobility.csv`, with the names of rows and columns exchanged.
std::string mobility_table(const HydrodynamicMatrices& matrices);

}  // namespace stokesbook
