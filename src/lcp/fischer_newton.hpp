#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Solves by Newton's method for the functions of Fischer and Burmeister,
/// \f$ \varphi_i = \sqrt{z_i^2 + w_i^2} - z_i - w_i \f$, which vanish where z_i, w_i >= 0 and
/// z_i w_i = 0.
///
/// A row of the Jacobian is \f$ (z_i/r - 1)\, e_i^T + (w_i/r - 1)\, M_i,\ r^2 = z_i^2 + w_i^2 \f$;
/// where both vanish, their limit along \f$ (1, \dots, 1) \f$ takes their place. The Newton step is
/// that of the matrix \f$ M + \varepsilon D,\ D \f$ diagonal and
/// \f$ \varepsilon = \min(10^{-6}, |\varphi|) \f$: without it, singular M with many multipliers
/// stall the search. Steps are halved until \f$ |\varphi|^2/2 \f$ falls by \f$ 10^{-4} \f$ of what
/// the slope promises; where the Newton step is not finite or does not descend, its negative
/// gradient is the step.
/// @param  problem  with m rows
/// @param  options  without a limit, 100 steps are allowed
/// @return          solved or stalled; iterations are steps
/// @throws std::invalid_argument when sizes do not agree
/// @throws std::domain_error when M or q is not finite
/// @par Accuracy    quadratic convergence where z + w > 0 and \f$ M_{AA} \f$ is regular, slower
///                  where not; @ref claim_11_7, @ref claim_11_8, @ref claim_11_11
/// @par Cost        2/3 m^3 operations a step
/// @par Not for     telling that there is no solution: it stalls
/// @sa source: De Luca, Facchinei, Kanzow, Math. Program. 75 (1996) 407
LcpResult fischer_newton(const LcpProblem& problem, const LcpOptions& options = {});

/// @}

}  // namespace stokesbook
