#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "closure/bordered_system.hpp"
#include "support/dense.hpp"
#include "support/distance.hpp"
#include "support/lopsided_curve.hpp"

namespace stokesbook::test {

inline constexpr std::array all_forms{ClosureForm::power_bordered, ClosureForm::scaled_bordered,
                                      ClosureForm::reduced};

inline Component free_body(const Shape& shape, Eigen::Index n, const Pose& pose,
                           const Load& load = {}) {
  const Curve curve = place(sample(shape, n, Side::fluid_outside), pose.position, pose.orientation);
  return {ComponentKind::free_body, curve, pose.position, load.force, load.torque, {}};
}

/// Returns a held body or an inner wall that moves rigidly.
inline Component held_body(const Shape& shape, Eigen::Index n, const Pose& pose,
                           const RigidMotion& motion) {
  Component held = free_body(shape, n, pose);
  held.kind = ComponentKind::prescribed;
  held.velocity = RigidModes(held.curve, held.centre).at_nodes(motion);
  return held;
}

inline ComplexVector all_nodes(const StokesProblem& problem) {
  return stokesbook::all_nodes(curves_of(problem));
}

inline Eigen::VectorXd solve(const DenseSystem& system) {
  return solve(system.matrix, system.rhs);
}

inline Completion solve_dense(const StokesProblem& problem, ClosureForm form) {
  return complete_dense(problem, form, solve(assemble(problem, form)));
}

}  // namespace stokesbook::test
