#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "closure/problem.hpp"
#include "krylov/layer_block.hpp"

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// Solves the whole system by a factorisation: for few unknowns, many right-hand sides, and gaps so
/// narrow that iterations are many.
///
/// With the layer \f$ L = -\frac12 + D + N_0 \f$ between all nodes, rigid motions K of the inner
/// components and their projection \f$ P = K\Pi \f$, the closure C acts on P
/// alone, and the system is
/// \f[ A = L(I-P) + CP = L + (CK - LK)\Pi. \f]
/// As a preconditioner it leaves to GMRES what the factorisation's rounding and the tolerance of
/// the layer's near corrections leave.
/// @par Accuracy  that of the layer; iterations of bodies that nearly touch, @ref claim_05_30
class DirectPreconditioner {
 public:
  /// Assembles and factorises the system.
  ///
  /// @param  problem  n nodes in all
  /// @param  layer    between any two different components
  /// @throws std::invalid_argument as Closure does
  /// @par Cost      \f$ \frac{16}{3}n^3 \f$ operations, \f$ 32 n^2 \f$ bytes
  DirectPreconditioner(const StokesProblem& problem, const LayerBlock& layer);

  /// Applies the inverse.
  ///
  /// @param  v  2n numbers, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @return    2n numbers, ordered as v, unit of v
  /// @par Cost  4 n^2 multiplications
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// @}

}  // namespace stokesbook
