#pragma once

#include <vector>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// Node values of three functions, real and imaginary parts apart.
struct BarycentricFunctions {
  /// Takes three functions apart.
  ///
  /// @param  f  N values
  /// @param  g  N values
  /// @param  h  N values, unit of g / length
  BarycentricFunctions(const Eigen::Ref<const ComplexVector>& f,
                       const Eigen::Ref<const ComplexVector>& g,
                       const Eigen::Ref<const ComplexVector>& h);

  Eigen::VectorXd fx,  ///< f
      fy,              ///< f
      gx,              ///< g
      gy,              ///< g
      hx,              ///< h
      hy;              ///< h
};

/// What a barycentric evaluation finds at a target.
struct BarycentricValues {
  Complex first,  ///< \f$ \sum_j w_j f_j \f$
      second;     ///< \f$ \sum_j w_j [g_j + (\bar z - \bar t_j) h_j] \f$
};

/// Compensated barycentric evaluation of Cauchy integrals on the fluid's side of a curve:
/// \f[ w_j = \frac{W_j}{\Delta},\quad W_j = \frac{s\,t'_j h}{2\pi i\,(t_j - z)},\quad
///     \Delta = \sum_j W_j + [s=-1]. \f]
/// At a node the weights are those of the node alone, so that the values there are the limits.
/// @par Accuracy  rounding at any distance, once the functions are resolved: @ref claim_06_1,
/// @ref claim_06_12; the side: @ref claim_06_28
/// @sa source: Helsing and Ojala, J. Comput. Phys. 227 (2008), 2899
class Barycentric {
 public:
  /// Takes the nodes and weights of a curve.
  /// @param  curve  N nodes
  explicit Barycentric(const Curve& curve);

  /// Evaluates at targets on the fluid's side or on nodes.
  ///
  /// @param  functions  at the N nodes
  /// @param  targets    m points, length
  /// @return            values at the m targets, units of f and g
  /// @par Cost          35 N operations and N / 2 divisions a target
  std::vector<BarycentricValues> operator()(const BarycentricFunctions& functions,
                                            const ComplexVector& targets) const;

  /// Evaluates the weights of all nodes at targets.
  ///
  /// @param  targets  m points on the fluid's side or on nodes, length
  /// @return          w, m x N
  /// @par Cost        10 N operations a target
  Eigen::MatrixXcd weights(const ComplexVector& targets) const;

  /// Evaluates \f$ \mathrm{Re}\,\Delta \f$: 1 in the fluid, 0 on the other side, once the curve is
  /// resolved; infinite on a node.
  ///
  /// @param  point  length
  /// @return        dimensionless
  /// @par Cost      5 N operations
  double side(Complex point) const;

 private:
  Eigen::Index size() const { return x_.size(); }
  Eigen::Index node_at(Complex target) const;

  Eigen::VectorXd x_, y_;    // nodes t_j
  Eigen::VectorXd cx_, cy_;  // s t'_j h / (2 pi i)
  double own_;               // [s = -1]
};

/// @}

}  // namespace stokesbook
