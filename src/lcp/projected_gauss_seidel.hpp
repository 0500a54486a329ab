#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Solves by sweeps that set \f$ z_i \leftarrow \max(0, z_i - w_i / M_{ii}) \f$, one i after
/// another.
///
/// For M symmetric and positive semidefinite every sweep lowers
/// \f$ \tfrac12 z \cdot M z + q \cdot z \f$.
/// @param  problem  with m rows, \f$ M_{ii} > 0 \f$
/// @param  options  without a limit, 1000 sweeps are allowed
/// @return          solved or stalled; iterations are sweeps
/// @throws std::invalid_argument when sizes do not agree, or M has a diagonal entry <= 0
/// @throws std::domain_error when M or q is not finite
/// @par Accuracy    linear convergence, as Gauss-Seidel's: for a chain of m contacts, of the order
///                  of m^2 sweeps a digit; @ref claim_11_4, @ref claim_11_5
/// @par Cost        4 m^2 operations a sweep
/// @par Not for     chains and contacts that nearly repeat each other; telling that there is no
///                  solution
/// @sa source: Cottle, Pang, Stone, The Linear Complementarity Problem (1992), 5.2
LcpResult projected_gauss_seidel(const LcpProblem& problem, const LcpOptions& options = {});

/// @}

}  // namespace stokesbook
