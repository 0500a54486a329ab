#pragma once

#include <optional>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/barycentric.hpp"

namespace stokesbook {

/// Node values of the three functions from which CauchyCurve evaluates the velocity of a double
/// layer. Each matrix has one column per density.
struct CauchyData {
  Eigen::MatrixXcd limit;  ///< U, limit of the velocity from the fluid, length / time
  Eigen::MatrixXcd phi;    ///< first Goursat function, length / time
  Eigen::MatrixXcd dphi;   ///< \f$ \phi' = d\phi/dz \f$, 1 / time
};

/// Node values of the three functions from which CauchyCurve evaluates pressure, vorticity and
/// strain of a double layer. Each matrix has one column per density.
struct CauchyDerivativeData {
  Eigen::MatrixXcd dphi;    ///< \f$ \phi' \f$, 1 / time
  Eigen::MatrixXcd ddphi;   ///< \f$ \phi'' \f$, 1 / (length time)
  Eigen::MatrixXcd stress;  ///< \f$ g = \psi' + \bar x\phi'' \f$, 1 / time
};

/// Evaluates the double layer of one curve at any distance with spectral accuracy: Cauchy integrals
/// give the limits of analytic functions on the curve, and the compensated barycentric formula
/// evaluates these functions away from the curve. All quantities are in the curve's own frame, so
/// that all bodies of one shape share one CauchyCurve.
///
/// With \f$ D[\eta] = \phi - z\overline{\phi'} - \overline{\psi} \f$ (06.8) and
/// \f$ \chi = \psi + \bar x\phi' = \overline{\phi - U} \f$ on the curve (06.12) the velocity is
/// (06.13)
/// \f[ u(z) = \sum_j w_j\phi_j - \overline{\sum_j w_j[\chi_j + (\bar z - \bar x_j)\phi'_j]} \f]
/// with the weights of Barycentric.
/// The derivatives have the same form. Pressure over viscosity and vorticity are
/// \f$ -4\,\mathrm{Re} \f$ and \f$ 4\,\mathrm{Im} \f$ of \f$ \sum_j w_j\phi'_j \f$. With
/// \f$ g = d\chi/dx - \phi'\,d\bar x/dx \f$ along the curve, half of the strain is (06.16)
/// \f[ \partial u/\partial\bar z = -\overline{\sum_j w_j[g_j + (\bar z - \bar x_j)\phi''_j]}. \f]
/// @par Accuracy  1e-13 relative at any distance, once the density is resolved: @ref claim_06_1,
/// @ref claim_06_6; with fewer nodes, that of the density, @ref claim_06_12
/// @par Not for   targets on the other side of the curve
/// @sa source: Helsing and Ojala, J. Comput. Phys. 227 (2008), 2899
class CauchyCurve {
 public:
  /// Prepares one curve of N nodes in its own frame.
  ///
  /// @param  storage  stored for curves that many bodies share: matrices, with O(N^2 log N)
  ///                  operations and 64 N^2 bytes; streamed: no matrices
  explicit CauchyCurve(const Curve& reference, KernelStorage storage = KernelStorage::stored);

  /// Computes the node values for k densities, N x k, in the curve's frame.
  ///
  /// @par Cost  12 N^2 k real multiplications; streamed: the kernels of N^2 k pairs
  CauchyData data(const Eigen::MatrixXcd& densities) const;

  /// Evaluates the velocity of a density on the fluid's side, at any distance or on a node.
  ///
  /// @par Cost  35 N operations and N / 2 divisions per target
  ComplexVector velocity(const CauchyData& data, Eigen::Index column,
                         const ComplexVector& targets) const;

  /// Assembles the matrix that maps a density to the velocities at targets. The product with this
  /// matrix equals data() followed by velocity().
  ///
  /// @param  targets  m points on the fluid's side or on nodes
  /// @return          2m x 2N, dimensionless, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @par Cost        16 N^2 real multiplications per target, as matrix products; streamed: also
  ///                  O(N^2 log N) for the matrices
  Eigen::MatrixXd velocity_rows(const ComplexVector& targets) const;

  /// Computes the node values for the derivatives of the flow, from data() of k densities, with
  /// O(N k log N) operations.
  CauchyDerivativeData derivative_data(const CauchyData& data) const;

  /// Evaluates pressure, vorticity and strain on the fluid's side, at any distance or on a node,
  /// where the values are the limits from the fluid. The cost is that of velocity().
  ///
  /// @par Accuracy  1e-11 relative at any distance, once the density is resolved: @ref claim_06_8,
  /// @ref claim_06_10
  std::vector<FlowDerivatives> derivatives(const CauchyDerivativeData& data, Eigen::Index column,
                                           const ComplexVector& targets) const;

  /// Returns whether a point of the curve's frame lies on the fluid's side of the curve or on a
  /// node: \f$ \mathrm{Re}\,\Delta > 1/2 \f$.
  ///
  /// @par Accuracy  the border between true and false is the curve, also between nodes, once the
  /// shape is resolved: @ref claim_06_25; its distance from the curve, as a function of N:
  /// @ref claim_06_28
  bool in_fluid(Complex point) const { return barycentric_.side(point) > 0.5; }

  const Curve& curve() const { return curve_; }  ///< returns the nodes, in the curve's own frame

 private:
  struct Matrices {
    Eigen::MatrixXcd phi;   // density -> phi
    Eigen::MatrixXcd dphi;  // density -> phi'
    Eigen::MatrixXd limit;  // density -> U: -1/2 + D, interleaved
  };
  Matrices matrices() const;

  Curve curve_;
  Barycentric barycentric_;
  StressletSum layer_;
  std::optional<Matrices> stored_;
};

}  // namespace stokesbook
