#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Solves by Newton's method for \f$ h_i = \min(z_i, w_i) = 0 \f$.
///
/// With A the set where \f$ w_i < z_i \f$, a step makes \f$ w_A \f$ and all other z vanish:
/// one solve with \f$ M_{AA} \f$, to which \f$ 10^{-12} \f$ of its diagonal is added where it is
/// singular. Steps are halved until \f$ |h|^2/2 \f$ falls by \f$ 10^{-4} \f$ of what Newton's slope
/// promises.
/// @param  problem  with m rows
/// @param  options  without a limit, 100 steps are allowed
/// @return          solved or stalled; iterations are steps
/// @throws std::invalid_argument when sizes do not agree
/// @throws std::domain_error when M or q is not finite
/// @par Accuracy    rounding after finitely many steps, where it does not stall; @ref claim_11_9;
///                  on a chain of m contacts m/2 of them, @ref claim_11_6
/// @par Cost        2/3 |A|^3 operations a step
/// @par Not for     M that is singular, where it may stall; telling that there is no solution
/// @sa source: Harker, Pang, Lect. Appl. Math. 26 (1990) 265
LcpResult minimum_map_newton(const LcpProblem& problem, const LcpOptions& options = {});

/// @}

}  // namespace stokesbook
