#pragma once

#include "support/problems.hpp"

namespace stokesbook::test {

/// Returns the mobility matrix of free bodies. Each column holds the motions (U_1, U_2, omega of
/// every body) under one unit load (F_1, F_2, L of every body).
///
/// @param  arm  from the centre of a body to the point at which forces act; if not 0, a planted
///              defect
inline Eigen::MatrixXd mobility_matrix(StokesProblem problem, ClosureForm form, Complex arm = {}) {
  const auto bodies = static_cast<Eigen::Index>(problem.components.size());
  Eigen::MatrixXd matrix(3 * bodies, 3 * bodies);
  for (Eigen::Index column = 0; column < 3 * bodies; ++column) {
    for (Component& component : problem.components) {
      component.force = 0.0;
      component.torque = 0.0;
    }
    Component& loaded = problem.components[static_cast<std::size_t>(column / 3)];
    if (column % 3 == 2) loaded.torque = 1.0;
    if (column % 3 != 2) loaded.force = column % 3 == 0 ? Complex{1.0} : imaginary;
    loaded.torque += cross(arm, loaded.force);
    const Completion result = solve_dense(problem, form);
    for (Eigen::Index k = 0; k < bodies; ++k) {
      const RigidMotion& motion = result.motions[static_cast<std::size_t>(k)];
      matrix.block<3, 1>(3 * k, column) << motion.velocity.real(), motion.velocity.imag(),
          motion.omega;
    }
  }
  return matrix;
}

}  // namespace stokesbook::test
