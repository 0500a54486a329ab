#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// A linear complementarity problem (11.2) whose matrix M is only applied to vectors, not stored.
struct LcpOperator {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> apply;  ///< maps z to M z
  Eigen::VectorXd offset;                                        ///< q, m numbers
  Eigen::VectorXd diagonal{};  ///< diagonal of M or an estimate of it, for scaling; empty: ones
};

/// Solves (11.2) by projected gradients,
/// \f$ z_{k+1} = \max(0, z_k - \alpha_k w_k) \f$, which require only products with M.
///
/// With \f$ \Delta z = z_k - z_{k-1},\ \Delta w = w_k - w_{k-1} \f$, the step length
/// \f$ \alpha_k \f$ alternates between the two of Barzilai and Borwein,
/// \f$ \Delta z \cdot \Delta z / \Delta z \cdot \Delta w \f$ and
/// \f$ \Delta z \cdot \Delta w / \Delta w \cdot \Delta w \f$. The first step has the length
/// \f$ 1 / |p|_\infty \f$ with the projected gradient p. There is no line search, so the residual
/// may grow in a step; the iterate with the least residual is returned.
/// @param  problem  with m rows, M symmetric and positive semidefinite
/// @param  options  default limit: 2000 products with M
/// @return          solved or stalled; iterations are products with M
/// @par Accuracy    linear convergence at best, the slower the worse M is conditioned;
///                  the same in all units, @ref claim_11_21
/// @par Cost        one product with M per step, and besides 10 m operations and 6 m numbers
/// @par Not for     M as ill-conditioned as Hilbert's matrix; proving that there is no solution
/// @sa source: Dai, Fletcher, Numer. Math. 100 (2005) 21; Yan, Corona, Malhotra, Veerapaneni,
///             Shelley, J. Comput. Phys. 416 (2020) 109524
LcpResult matrix_free_barzilai_borwein(const LcpOperator& problem, const LcpOptions& options = {});

/// Solves as matrix_free_barzilai_borwein() does, for a matrix that is stored.
LcpResult barzilai_borwein(const LcpProblem& problem, const LcpOptions& options = {});

}  // namespace stokesbook
