#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Applies the diagonal of the double layer of a curve on itself: the limit (02.9) of the kernel
/// times the weight, \f$ -\frac{s\kappa_j w_j}{2\pi} t_j (t_j\cdot\eta_j) \f$.
///
/// Density and velocities are those at the nodes, length / time.
ComplexVector diagonal_velocity(const Curve& curve, const ComplexVector& density);

/// Assembles the double layer (02.6) of several curves at all their n nodes, \f$ D[\eta](x_i) \f$,
/// by the trapezoid rule. The limit of the layer from the fluid is \f$ -\frac12\eta + D\eta \f$
/// (02.8).
///
/// @return        2n x 2n, dimensionless; curve by curve, interleaved (x_0, y_0, x_1, y_1, ...)
/// @par Accuracy  geometric in n for analytic curves and densities, @ref claim_02_13, with the
/// diagonal of @ref claim_02_15; geometric in the distance of two curves over the node spacing,
/// @ref claim_03_31
/// @par Cost      n^2 kernel evaluations
/// @par Not for   curves nearer to each other than about 5 node spacings: use NearCorrection
Eigen::MatrixXd double_layer_matrix(const std::vector<Curve>& curves);

/// Assembles the double layer of one curve at its own nodes.
Eigen::MatrixXd double_layer_matrix(const Curve& curve);

/// Measures how well the nodes of a curve resolve the double layer of the curve on itself: returns
/// the largest residual of \f$ (\frac{s}{2} + D) v = 0 \f$ (02.7) among the rigid motions v,
/// relative to max |v|.
///
/// The residual is measured in the Fourier modes |k| <= 4, on which motions and loads depend. The
/// modes of the kernel beyond N alias onto low modes. The tail of a density does not show this
/// error, but the residual does.
/// @param  curve  N nodes, N >= 10
/// @par Cost      N^2 kernel evaluations
double rigid_motion_residual(const Curve& curve);

/// Views plane vectors as a real vector (x_0, y_0, x_1, y_1, ...): the same memory.
///
/// @par Not for   temporaries, unless the view is used in the same expression
inline Eigen::Map<const Eigen::VectorXd> interleaved(const ComplexVector& v) {
  return {reinterpret_cast<const double*>(v.data()), 2 * v.size()};
}

/// Views a real vector (x_0, y_0, x_1, y_1, ...) as plane vectors: the same memory.
///
/// @par Not for   temporaries, unless the view is used in the same expression
inline Eigen::Map<const ComplexVector> deinterleaved(const Eigen::Ref<const Eigen::VectorXd>& v) {
  return {reinterpret_cast<const Complex*>(v.data()), v.size() / 2};
}

/// Writes a real-linear map of plane vectors, \f$ \eta \to A\eta + B\bar\eta \f$, as a real matrix
/// that acts on interleaved() vectors; A and B have the same size.
Eigen::MatrixXd interleaved_map(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

}  // namespace stokesbook
