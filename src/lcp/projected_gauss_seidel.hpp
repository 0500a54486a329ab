#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// Solves (11.2) by sweeps that set \f$ z_i \leftarrow \max(0, z_i - w_i / M_{ii}) \f$ for one i
/// after another.
///
/// If M is symmetric and positive semidefinite, every sweep lowers
/// \f$ \tfrac12 z \cdot M z + q \cdot z \f$ (11.3).
/// @param  problem  with m rows, \f$ M_{ii} > 0 \f$
/// @param  options  default limit: 1000 sweeps
/// @return          solved or stalled; iterations are sweeps
/// @throws std::invalid_argument also when M has a diagonal entry <= 0
/// @par Accuracy    linear convergence, like the Gauss-Seidel method: a chain of m contacts takes
///                  O(m^2) sweeps per digit; @ref claim_11_4, @ref claim_11_5
/// @par Cost        4 m^2 operations per sweep
/// @par Not for     chains, and contacts that nearly repeat each other; proving that there is no
///                  solution
/// @sa source: Cottle, Pang, Stone, The Linear Complementarity Problem (1992), 5.2
LcpResult projected_gauss_seidel(const LcpProblem& problem, const LcpOptions& options = {});

}  // namespace stokesbook
