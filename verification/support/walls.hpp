#pragma once

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "support/problems.hpp"

namespace stokesbook::test {

inline Component enclosing_wall(const Shape& shape, Eigen::Index n, const Pose& pose,
                                const RigidMotion& motion = {}) {
  const Curve curve = place(sample(shape, n, Side::fluid_inside), pose.position, pose.orientation);
  const ComplexVector velocity = RigidModes(curve, pose.position).at_nodes(motion);
  return {ComponentKind::enclosing_wall, curve, pose.position, {}, 0.0, velocity};
}

/// Assembles a bounded problem and adds `scale` times N_0 on its enclosing wall.
inline DenseSystem assemble_bounded(const StokesProblem& problem, ClosureForm form,
                                    double scale = 1.0) {
  DenseSystem system = assemble(problem, form);
  Eigen::Index first = 0;
  for (const Component& component : problem.components) {
    const Eigen::Index size = 2 * component.curve.size();
    if (component.kind == ComponentKind::enclosing_wall) {
      system.matrix.block(first, first, size, size) += scale * null_space_matrix(component.curve);
    }
    first += size;
  }
  return system;
}

inline Completion solve_bounded(const StokesProblem& problem, ClosureForm form,
                                double scale = 1.0) {
  return complete_dense(problem, form, solve(assemble_bounded(problem, form, scale)));
}

}  // namespace stokesbook::test
