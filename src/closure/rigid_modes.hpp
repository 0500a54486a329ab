#pragma once

#include <Eigen/Core>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Velocity \f$ U + \omega (x - c)^\perp \f$ (03.1) of a rigid body about a centre c.
struct RigidMotion {
  Complex velocity;    ///< U, length / time
  double omega = 0.0;  ///< counter-clockwise, 1 / time
};

/// The rigid motions on one curve, and the projection P onto these motions (03.9).
///
/// With the mean \f$ \langle f\rangle = \frac{1}{|\Gamma|}\int_\Gamma f\,ds \f$ and the centroid
/// \f$ b = \langle x\rangle \f$ of the curve, the projection is
/// \f[ U_b = \langle\eta\rangle,\quad \omega = \langle\eta\cdot(x-b)^\perp\rangle / a^2,\quad
///     a^2 = \langle|x-b|^2\rangle. \f]
class RigidModes {
 public:
  /// Prepares the projection of one curve with N nodes, onto motions about the centre c, with O(N)
  /// operations.
  RigidModes(const Curve& curve, Complex centre);

  /// Projects a density at the nodes, length / time, onto the rigid motion that is nearest in the
  /// mean square.
  ///
  /// @par Accuracy  that of the rule: geometric in N, @ref claim_03_14; exact for rigid motions
  RigidMotion project(const Eigen::Ref<const ComplexVector>& density) const;

  /// Evaluates a rigid motion about the centre at the nodes: N velocities, length / time.
  ComplexVector at_nodes(const RigidMotion& motion) const;

  /// Returns a, the root mean square distance of the curve from its centroid, length.
  double gyration_radius() const { return gyration_radius_; }

 private:
  Eigen::VectorXd mean_weights_;  // w_j / |Gamma|
  ComplexVector turn_;            // (x - b)^perp
  Complex offset_;                // c - b
  double gyration_radius_;
};

/// The rigid motions of a curve with N nodes as matrices.
///
/// A motion consists of U_1, U_2 and a omega with the radius of gyration a, so that all three
/// numbers are velocities.
struct RigidModeMatrices {
  double radius = 0.0;         ///< a, length
  Eigen::MatrixXd modes;       ///< K, 2N x 3: maps motions to velocities at the nodes, interleaved
  Eigen::MatrixXd projection;  ///< Pi, 3 x 2N: maps densities to motions, P = K Pi
};

/// Assembles the matrices of a curve's rigid motions about a centre, by O(N^2) operations.
RigidModeMatrices rigid_mode_matrices(const Curve& curve, Complex centre);

}  // namespace stokesbook
