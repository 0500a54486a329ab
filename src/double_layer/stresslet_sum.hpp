#pragma once

#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "double_layer/stresslet_block.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// The ways in which a sum over all pairs of nodes provides its kernel.
enum class KernelStorage {
  streamed,  ///< evaluated anew in every application
  stored     ///< kept as a dense matrix, 32 bytes per pair
};

/// The trapezoid sum of the double layer (02.6) over all nodes of several curves, planned once and
/// applied many times.
///
/// \f$ u(x_i) = \sum_j \frac{w_j}{\pi} \frac{(r\cdot n_j)(r\cdot\eta_j)}{\rho^4} r \f$ with
/// \f$ r = x_i - y_j \f$ and \f$ \rho = \max(|r|, w_j/2) \f$.
///
/// The lower bound of \f$ \rho \f$ makes the term of a node on itself zero; diagonal_velocity() is
/// the limit of this term. Between nodes of different curves that nearly touch, the bound keeps a
/// term as small as the density. A near correction, which subtracts the term again, thus loses no
/// digits by cancellation.
/// @par Accuracy  of the rule: geometric in the distance over the node spacing, @ref claim_02_6
/// @par Cost      one kernel evaluation per pair; results do not depend on the number of threads
class StressletSum {
 public:
  /// Plans the sum over all nodes of the curves.
  ///
  /// @par Cost  O(n); stored: n^2 kernel evaluations and 32 n^2 bytes
  explicit StressletSum(const std::vector<Curve>& curves,
                        KernelStorage storage = KernelStorage::streamed);

  /// Evaluates velocities at the nodes themselves, from a density at all nodes in the curves'
  /// order, length / time.
  ///
  /// @par Cost  n^2 kernel evaluations, or 4 n^2 multiplications by the stored matrix
  ComplexVector operator()(const ComplexVector& density) const;

  /// Evaluates velocities at m arbitrary targets, without storing a matrix.
  ///
  /// @par Cost     m n kernel evaluations
  /// @par Not for  targets nearer than about 5 node spacings: add a NearCorrection
  ComplexVector operator()(const ComplexVector& targets, const ComplexVector& density) const;

  /// Assembles the map from a density to the velocities at m targets: 2m x 2n, dimensionless,
  /// interleaved (x_0, y_0, x_1, y_1, ...).
  Eigen::MatrixXd matrix(const ComplexVector& targets) const;

  /// Evaluates pressure, vorticity and strain at m targets, 1 / time, see stresslet_derivatives().
  ///
  /// \f$ \rho \f$ is bounded as for velocities, so that a near correction can subtract the terms
  /// again.
  /// @par Cost     m n kernel evaluations
  /// @par Not for  targets nearer than about 6 node spacings: add near_derivative_corrections()
  std::vector<FlowDerivatives> derivatives(const ComplexVector& targets,
                                           const ComplexVector& density) const;

  Eigen::Index size() const { return nodes_.size(); }  ///< returns the number n of nodes

  /// Chooses the storage for which repeated application is faster, by a measured break-even: a
  /// matrix is stored if it fits into the fast cache.
  static KernelStorage automatic_storage(Eigen::Index n_nodes);

 private:
  ComplexVector positions() const;

  StressletNodes nodes_;
  Eigen::MatrixXd matrix_;  // empty if the kernel is streamed
};

}  // namespace stokesbook
