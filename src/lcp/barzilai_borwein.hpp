#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// A problem whose matrix is only applied.
struct LcpOperator {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> apply;  ///< z -> M z
  Eigen::VectorXd offset;                                        ///< q, m numbers
  Eigen::VectorXd diagonal{};  ///< of M, as far as known: it scales; empty: ones
};

/// Solves by projected gradients,
/// \f$ z_{k+1} = \max(0, z_k - \alpha_k w_k) \f$, that need only products with M.
///
/// With \f$ s = z_k - z_{k-1},\ y = w_k - w_{k-1} \f$, the lengths of Barzilai and Borwein
/// alternate: \f$ s \cdot s / s \cdot y \f$ and \f$ s \cdot y / y \cdot y \f$; the first is
/// \f$ 1 / |p|_\infty \f$, p the projected gradient. No search makes the residual fall step by
/// step; the point of the least one is returned.
/// @param  problem  with m rows, M symmetric and positive semidefinite
/// @param  options  without a limit, 2000 products are allowed
/// @return          solved or stalled; iterations are products with M
/// @throws std::invalid_argument when sizes do not agree
/// @throws std::domain_error when numbers are not finite
/// @par Accuracy    linear convergence at best, slower the worse M is conditioned;
///                  the same in all units, @ref claim_11_21
/// @par Cost        a product with M a step, 10 m operations and 6 m numbers beside it
/// @par Not for     M as ill-conditioned as Hilbert's; telling that there is no solution
/// @sa source: Dai, Fletcher, Numer. Math. 100 (2005) 21; Yan, Corona, Malhotra, Veerapaneni,
///             Shelley, J. Comput. Phys. 416 (2020) 109524
LcpResult matrix_free_barzilai_borwein(const LcpOperator& problem, const LcpOptions& options = {});

/// The same for a matrix that is there.
///
/// @param  problem  with m rows, M symmetric and positive semidefinite
/// @param  options  without a limit, 2000 products are allowed
/// @return          solved or stalled; iterations are products with M
/// @throws std::invalid_argument when M is not square or q not as long
/// @throws std::domain_error when M or q is not finite
LcpResult barzilai_borwein(const LcpProblem& problem, const LcpOptions& options = {});

/// @}

}  // namespace stokesbook
