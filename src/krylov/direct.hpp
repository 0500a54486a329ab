#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "krylov/block_diagonal.hpp"

namespace stokesbook {

/// Solves the whole system by a factorisation, for few unknowns, many right-hand sides, and gaps so
/// narrow that many iterations would be necessary.
///
/// Let \f$ L = -\frac12 + D + N_0 \f$ be the layer between all nodes, K the rigid motions of the
/// inner components, and \f$ P = K\Pi \f$ the projection onto these motions. The closure C depends
/// on the rigid part of a density only, so that the system is
/// \f[ A = L(I-P) + CP = L + (CK - LK)\Pi. \f]
/// @par Accuracy  that of the layer; iterations for bodies that nearly touch, @ref claim_13_10
class DirectPreconditioner {
 public:
  /// Assembles and factorises the system of a problem with n nodes, from the layers between any two
  /// different components.
  ///
  /// @throws std::invalid_argument when Closure rejects the problem
  /// @par Cost  \f$ \frac{16}{3}n^3 \f$ operations, \f$ 32 n^2 \f$ bytes
  DirectPreconditioner(const StokesProblem& problem, const LayerBlock& layer);

  /// Applies the inverse to 2n interleaved numbers (x_0, y_0, x_1, y_1, ...), by 4 n^2
  /// multiplications.
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace stokesbook
