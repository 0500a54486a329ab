#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Solves (11.2) by Newton's method for the minimum map \f$ h_i = \min(z_i, w_i) = 0 \f$ (11.7).
///
/// Let A be the set of indices with \f$ w_i < z_i \f$. A step makes \f$ w_A \f$ and all other z
/// vanish, by one solve with \f$ M_{AA} \f$. If this block is singular, \f$ 10^{-12} \f$ of the
/// diagonal of M is added to its diagonal. Steps are halved until \f$ |h|^2/2 \f$ falls by
/// \f$ 10^{-4} \f$ of the decrease that the slope of a Newton step predicts.
/// @param  problem  with m rows
/// @param  options  default limit: 100 steps
/// @return          solved or stalled; iterations are steps
/// @throws std::invalid_argument when sizes do not agree
/// @throws std::domain_error when M or q is not finite
/// @par Accuracy    rounding after finitely many steps if the iteration does not stall,
///                  @ref claim_11_9; a chain of m contacts takes m/2 steps, @ref claim_11_6
/// @par Cost        2/3 |A|^3 operations per step
/// @par Not for     singular M, for which the iteration may stall; proving that there is no
///                  solution
/// @sa source: Harker, Pang, Lect. Appl. Math. 26 (1990) 265
LcpResult minimum_map_newton(const LcpProblem& problem, const LcpOptions& options = {});

/// @}

}  // namespace stokesbook
