#pragma once

#include <Eigen/Core>

#include "closure/rigid_modes.hpp"
#include "fmm/translations.hpp"

namespace stokesbook {

/// Expansions of chapter 08 as matrices, in single precision, for couplings of few directions.
///
/// An expansion of order p about the centre of a disk is a vector of 4(p + 1) numbers, the columns
/// of an Expansion one after another. With an enclosing wall, one more number follows: the flux
/// through the wall, which N_0 (04.6) turns into a flow of all of the wall. No translation changes
/// it, and pieces of the boundary set it themselves: it is 0 in the matrices from and to nodes.
class FarField {
 public:
  /// @param  order        p of all expansions
  /// @param  gauge        gauge length of Stokeslets, > 0
  /// @param  flux_weight  how much the flux through an enclosing wall counts; 0: there is no wall
  FarField(int order, double gauge, double flux_weight = 0.0);

  /// Returns the number of coefficients.
  Eigen::Index size() const { return count() + (flux_weight_ > 0.0 ? 1 : 0); }

  /// Assembles the multipole expansion of a curve's double layer, size() x 2N, by p2m().
  Eigen::MatrixXf of_densities(const Box& disk, const Curve& curve) const;

  /// Assembles the multipole expansion of the loads \f$ -4\pi\mu U \f$ and \f$ -4\pi\mu a^2\omega
  /// \f$ at a centre, size() x 3, for the unit motions of RigidModeMatrices.
  Eigen::MatrixXf of_loads(const Box& disk, Complex centre, double gyration_radius) const;

  /// Assembles the velocities of a local expansion at M points of its disk, 2M x size(), by
  /// l2p().
  Eigen::MatrixXf at_points(const Box& disk, const ComplexVector& points) const;

  /// Assembles a translation by Translations::m2m().
  Eigen::MatrixXf multipole_to_multipole(const Box& from, const Box& to) const;

  /// Assembles a translation by Translations::l2l().
  Eigen::MatrixXf local_to_local(const Box& from, const Box& to) const;

  /// Assembles a conversion by Translations::m2l(), with the gauge length of the Stokeslets.
  Eigen::MatrixXf multipole_to_local(const Box& from, const Box& to) const;

  /// Returns weights of the coefficients: the powers \f$ 2^{-k} \f$ by which they count at the
  /// distance of two radii, and the weight of the flux.
  Eigen::VectorXf weights() const;

 private:
  Eigen::Index count() const { return 4 * (translations_.order() + 1); }  // of an Expansion

  Translations translations_;
  Expansions units_;  // every coefficient alone, as the fields of one box
  double log_gauge_;
  double flux_weight_;
};

}  // namespace stokesbook
