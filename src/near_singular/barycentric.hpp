#pragma once

#include <vector>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// The two sums that a barycentric evaluation computes at a target z.
struct BarycentricValues {
  Complex first,  ///< \f$ \sum_j w_j f_j \f$
      second;     ///< \f$ \sum_j w_j [g_j + (\bar z - \bar x_j) h_j] \f$
};

/// Evaluates Cauchy integrals on the fluid's side of a curve by the compensated barycentric formula
/// (06.14):
/// \f[ w_j = \frac{W_j}{\Delta},\quad W_j = \frac{s\,x'_j}{iN\,(x_j - z)},\quad
///     \Delta = \sum_j W_j + [s=-1]. \f]
/// The last term is 1 for a body and 0 for the enclosing wall. If the target is a node, then the
/// node has the weight 1, and the values are the limits from the fluid.
/// @par Accuracy  rounding at any distance, once the functions are resolved: @ref claim_06_1,
/// @ref claim_06_12; side(): @ref claim_06_28
/// @sa source: Helsing and Ojala, J. Comput. Phys. 227 (2008), 2899
class Barycentric {
 public:
  /// Stores the N nodes of a curve and the factors of its Cauchy integrals.
  explicit Barycentric(const Curve& curve);

  /// Evaluates both sums, from N values of each function at the nodes, at targets on the fluid's
  /// side of the curve or on its nodes.
  ///
  /// @par Cost  35 N operations and N / 2 divisions per target
  std::vector<BarycentricValues> operator()(const Eigen::Ref<const ComplexVector>& f,
                                            const Eigen::Ref<const ComplexVector>& g,
                                            const Eigen::Ref<const ComplexVector>& h,
                                            const ComplexVector& targets) const;

  /// Evaluates the limits of a Cauchy integral from the fluid at all nodes (06.11), from the values
  /// of a function there.
  ///
  /// @par Cost  18 N^2 operations and N^2 divisions
  ComplexVector limits(const ComplexVector& f) const;

  /// Evaluates the weights w, m x N, at m targets on the fluid's side or on nodes, with 10 N
  /// operations per target.
  Eigen::MatrixXcd weights(const ComplexVector& targets) const;

  /// Evaluates \f$ \mathrm{Re}\,\Delta \f$. If the curve is resolved, this number is greater than
  /// 1/2 in the fluid, tending to 1 away from the curve, and less than 1/2 on the other side,
  /// tending to 0 (06.15). On a node the number is infinite. The cost is 5 N operations.
  double side(Complex point) const;

 private:
  Eigen::Index size() const { return x_.size(); }
  Eigen::Index node_at(Complex target) const;

  Eigen::VectorXd x_, y_;    // nodes t_j
  Eigen::VectorXd cx_, cy_;  // s t'_j h / (2 pi i)
  double own_;               // [s = -1]: 1 for a body, 0 for the enclosing wall
};

}  // namespace stokesbook
