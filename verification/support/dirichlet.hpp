#pragma once

#include "double_layer/double_layer.hpp"
#include "support/dense.hpp"

namespace stokesbook::test {

/// Completes -1/2 + D of one curve to a regular matrix. The null space (the rigid motions on a
/// body, one density of normal flux on an enclosing wall) gets the eigenvalue -1.
///
/// @param  curve  nodes
/// @param  layer  D, from double_layer_matrix(curve)
inline Eigen::MatrixXd completed_system(const Curve& curve, const Eigen::MatrixXd& layer) {
  const Eigen::Index n = curve.size();
  const Eigen::VectorXd w = weights(curve).cwiseSqrt();
  Eigen::MatrixXd modes(2 * n, curve.side == Side::fluid_inside ? 1 : 3);
  const auto set_mode = [&](Eigen::Index k, const ComplexVector& mode) {
    const ComplexVector weighted = mode.cwiseProduct(w);
    modes.col(k) = interleaved(weighted);
  };
  if (curve.side == Side::fluid_inside) {
    set_mode(0, normals(curve));
  } else {
    set_mode(0, ComplexVector::Ones(n));
    set_mode(1, ComplexVector::Constant(n, imaginary));
    set_mode(2, imaginary * (curve.x.array() - boundary_centroid(curve)).matrix());
  }
  modes.colwise().normalize();
  Eigen::VectorXd scale(2 * n);
  for (Eigen::Index i = 0; i < 2 * n; ++i) scale[i] = w[i / 2];
  const Eigen::MatrixXd projection =
      scale.cwiseInverse().asDiagonal() * modes * modes.transpose() * scale.asDiagonal();
  return layer - 0.5 * Eigen::MatrixXd::Identity(2 * n, 2 * n) - projection;
}

/// Solves (-1/2 + D) eta = u densely on one curve. The velocity limit u belongs to a flow without
/// force and torque (body) or without net flux (enclosing wall). The solution is not unique. The
/// function returns the solution of completed_system(), which on a body has no rigid part.
inline ComplexVector density_of(const Curve& curve, const ComplexVector& velocity) {
  const Eigen::VectorXd density =
      solve(completed_system(curve, double_layer_matrix(curve)), interleaved(velocity));
  return deinterleaved(density);
}

}  // namespace stokesbook::test
