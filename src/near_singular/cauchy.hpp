#pragma once

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "near_singular/barycentric.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// Node values of the functions that carry a double layer's velocity to any distance from its
/// curve.
///
/// One column a density. \f$ \phi \f$ is the first Goursat function, \f$ \phi' = d\phi/dz \f$, and
/// U the velocity's limit from the fluid, all at the nodes.
struct CauchyData {
  Eigen::MatrixXcd limit;  ///< U, length / time
  Eigen::MatrixXcd phi;    ///< length / time
  Eigen::MatrixXcd dphi;   ///< 1 / time
};

/// Node values of the functions that carry the derivatives of a double layer's flow, see
/// CauchyCurve. One column a density.
struct CauchyDerivativeData {
  Eigen::MatrixXcd dphi;    ///< \f$ \phi' \f$, 1 / time
  Eigen::MatrixXcd ddphi;   ///< \f$ \phi'' \f$, 1 / (length time)
  Eigen::MatrixXcd stress;  ///< \f$ g = \psi' + \bar t\phi'' \f$, 1 / time
};

/// The spectral close evaluation of one curve's double layer: Cauchy integrals on the curve,
/// compensated barycentric interpolation off it. Everything is in the curve's own frame, so that
/// all bodies of one shape share it.
///
/// With \f$ D[\eta] = \phi - z\overline{\phi'} - \overline{\psi} \f$ and
/// \f$ \chi = \psi + \bar t\phi' = \overline{\phi - U} \f$ on the curve,
/// \f[ U(z) = \sum_j w_j\phi_j - \overline{\sum_j w_j[\chi_j + (\bar z - \bar t_j)\phi'_j]} \f]
/// with the weights of Barycentric.
/// Derivatives have the same form: pressure over viscosity and vorticity are
/// \f$ -4\,\mathrm{Re} \f$ and \f$ 4\,\mathrm{Im} \f$ of \f$ \sum_j w_j\phi'_j \f$, and with
/// \f$ g = d\chi/dt - \phi'\,d\bar t/dt \f$ along the curve
/// \f[ \partial u/\partial\bar z = -\overline{\sum_j w_j[g_j + (\bar z - \bar t_j)\phi''_j]}. \f]
/// @par Accuracy  1e-13 relative at any distance, once the density is resolved: @ref claim_06_1,
/// @ref claim_06_6; until then that of the density, @ref claim_06_12
/// @par Not for   targets on the other side of the curve
/// @sa source: Helsing and Ojala, J. Comput. Phys. 227 (2008), 2899
class CauchyCurve {
 public:
  /// Prepares the matrices of one curve.
  ///
  /// @param  reference  N nodes, in the curve's own frame
  /// @par Cost          O(N^2 log N) operations, 64 N^2 bytes
  explicit CauchyCurve(const Curve& reference);

  /// Computes the node values for densities given in the curve's frame, one a column.
  ///
  /// @param  densities  N x k, length / time
  /// @return            limit and phi, N x k, length / time; dphi, N x k, 1 / time
  /// @par Cost          12 N^2 k real multiplications
  CauchyData data(const Eigen::MatrixXcd& densities) const;

  /// Evaluates the velocity on the fluid's side, at any distance or on a node.
  ///
  /// @param  data     from data()
  /// @param  column   which density
  /// @param  targets  m points, in the curve's frame, length
  /// @return          m velocities in the curve's frame, length / time
  /// @par Cost        35 N operations and N / 2 divisions a target
  ComplexVector velocity(const CauchyData& data, Eigen::Index column,
                         const ComplexVector& targets) const;

  /// Assembles the map from a density to the velocities at targets, of velocity() and data().
  ///
  /// @param  targets  m points on the fluid's side or on nodes, in the curve's frame, length
  /// @return          2m x 2N, dimensionless, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @par Cost        16 N^2 real multiplications a target, as matrix products
  Eigen::MatrixXd velocity_rows(const ComplexVector& targets) const;

  /// Computes the node values for the derivatives of the flow.
  ///
  /// @param  data  from data(), k densities
  /// @return       N x k each
  /// @par Cost     O(N k log N)
  CauchyDerivativeData derivative_data(const CauchyData& data) const;

  /// Evaluates pressure, vorticity and strain on the fluid's side, at any distance or on a node,
  /// where they are the limits.
  ///
  /// @param  data     from derivative_data()
  /// @param  column   which density
  /// @param  targets  m points, in the curve's frame, length
  /// @return          m values in the curve's frame, 1 / time
  /// @par Accuracy  1e-11 relative at any distance, once the density is resolved: @ref claim_06_8,
  /// @ref claim_06_10
  /// @par Cost      as velocity()
  std::vector<FlowDerivatives> derivatives(const CauchyDerivativeData& data, Eigen::Index column,
                                           const ComplexVector& targets) const;

  /// Tells on which side of the curve a point lies, by \f$ \mathrm{Re}\,\Delta > 1/2 \f$.
  ///
  /// @param  point  in the curve's frame, length
  /// @return        true in the fluid and on a node
  /// @par Accuracy  the border is the curve, between nodes too, once its shape is resolved:
  /// @ref claim_06_25; before, see @ref claim_06_28
  /// @par Cost      O(N)
  bool in_fluid(Complex point) const { return barycentric_.side(point) > 0.5; }

  /// Returns the nodes.
  /// @return N nodes, in the curve's own frame
  const Curve& curve() const { return curve_; }

 private:
  Curve curve_;
  Barycentric barycentric_;
  Eigen::MatrixXcd phi_;   // density -> phi
  Eigen::MatrixXcd dphi_;  // density -> phi'
  Eigen::MatrixXd limit_;  // -1/2 + D, interleaved
};

/// @}

}  // namespace stokesbook
