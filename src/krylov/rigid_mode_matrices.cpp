// Assembles the matrices K and Pi of a component's rigid motions, P = K Pi (05.15), and the
// velocities C K that a closure adds for these motions.
#include "krylov/rigid_mode_matrices.hpp"

#include "double_layer/double_layer.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

RigidModeMatrices rigid_mode_matrices(const Component& component) {
  const RigidModes modes(component.curve, component.centre);
  const Index n = component.curve.size();
  const double a = modes.gyration_radius();
  RigidModeMatrices result{a, MatrixXd(2 * n, 3), MatrixXd(3, 2 * n)};
  // The columns of K are the velocities of the motions U_1 = 1, U_2 = 1 and a omega = 1.
  const RigidMotion motions[] = {{1.0, 0.0}, {imaginary, 0.0}, {0.0, 1.0 / a}};
  for (Index k = 0; k < 3; ++k) {
    const ComplexVector velocity = modes.at_nodes(motions[k]);
    result.modes.col(k) = interleaved(velocity);
  }
  // The columns of Pi are the motions (U_1, U_2, a omega) of unit densities.
  ComplexVector unit = ComplexVector::Zero(n);
  for (Index k = 0; k < 2 * n; ++k) {
    unit[k / 2] = k % 2 == 0 ? Complex{1.0} : imaginary;
    const RigidMotion motion = modes.project(unit);
    result.projection.col(k) << motion.velocity.real(), motion.velocity.imag(), a * motion.omega;
    unit[k / 2] = 0.0;
  }
  return result;
}

MatrixXd closed_modes(const Closure& closure, const MatrixXd& modes, Index first, Index n) {
  MatrixXd closed(2 * n, modes.cols());
  for (Index mode = 0; mode < modes.cols(); ++mode) {
    ComplexVector density = ComplexVector::Zero(n);
    density.segment(first, modes.rows() / 2) = deinterleaved(modes.col(mode));
    const ComplexVector velocity = closure.velocity(density);
    closed.col(mode) = interleaved(velocity);
  }
  return closed;
}

}  // namespace stokesbook
