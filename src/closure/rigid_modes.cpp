// Projects densities onto the rigid motions of a curve, by means over the curve (03.9).
#include "closure/rigid_modes.hpp"

#include <cmath>

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

}  // namespace stokesbook
