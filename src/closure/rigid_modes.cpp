// Projects densities onto the rigid motions of a curve, by means over the curve (03.9), and
// assembles the matrices of this projection, P = K Pi.
#include "closure/rigid_modes.hpp"

#include <cmath>

#include "double_layer/double_layer.hpp"

namespace stokesbook {

RigidModes::RigidModes(const Curve& curve, Complex centre) {
  const Eigen::VectorXd w = weights(curve);
  mean_weights_ = w / w.sum();
  const Complex centroid = boundary_centroid(curve);
  turn_ = imaginary * (curve.x.array() - centroid).matrix();
  offset_ = centre - centroid;
  gyration_radius_ = std::sqrt(mean_weights_.dot(turn_.cwiseAbs2()));
}

RigidMotion RigidModes::project(const Eigen::Ref<const ComplexVector>& density) const {
  // U_b = <eta> and omega = <eta . (x - b)^perp> / a^2 (03.9); the velocity of the centre is
  // U_b + omega (c - b)^perp.
  const Complex mean = density.cwiseProduct(mean_weights_).sum();
  const double spin = (turn_.conjugate().cwiseProduct(density)).real().dot(mean_weights_) /
                      (gyration_radius_ * gyration_radius_);
  return {mean + spin * perp(offset_), spin};
}

ComplexVector RigidModes::at_nodes(const RigidMotion& motion) const {
  // U_b + omega (x - b)^perp with U_b = U - omega (c - b)^perp.
  const Complex centroid_velocity = motion.velocity - motion.omega * perp(offset_);
  return (centroid_velocity + motion.omega * turn_.array()).matrix();
}

RigidModeMatrices rigid_mode_matrices(const Curve& curve, Complex centre) {
  const RigidModes modes(curve, centre);
  const Eigen::Index n = curve.size();
  const double a = modes.gyration_radius();
  RigidModeMatrices result{a, Eigen::MatrixXd(2 * n, 3), Eigen::MatrixXd(3, 2 * n)};
  // The columns of K are the velocities of the motions U_1 = 1, U_2 = 1 and a omega = 1.
  const RigidMotion motions[] = {{1.0, 0.0}, {imaginary, 0.0}, {0.0, 1.0 / a}};
  for (Eigen::Index k = 0; k < 3; ++k) {
    result.modes.col(k) = interleaved(modes.at_nodes(motions[k]));
  }
  // The columns of Pi are the motions (U_1, U_2, a omega) of unit densities.
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    const Complex direction = k % 2 == 0 ? Complex{1.0} : imaginary;
    const auto [velocity, omega] = modes.project(ComplexVector::Unit(n, k / 2) * direction);
    result.projection.col(k) << velocity.real(), velocity.imag(), a * omega;
  }
  return result;
}

}  // namespace stokesbook
