#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// Solves (11.2) by Newton's method for the functions of Fischer and Burmeister (11.7),
/// \f$ \varphi_i = \sqrt{z_i^2 + w_i^2} - z_i - w_i \f$, which vanish exactly where z_i, w_i >= 0
/// and z_i w_i = 0.
///
/// Row i of the Jacobian (11.8) is
/// \f$ (z_i/r - 1)\, e_i^T + (w_i/r - 1)\, M_i,\ r^2 = z_i^2 + w_i^2 \f$; if z_i and w_i both
/// vanish, the row is the limit along \f$ z = (1, \dots, 1) \f$. Before the solve,
/// \f$ \varepsilon = \min(10^{-6}, |\varphi|) \f$ is subtracted from the diagonal of the Jacobian:
/// without this shift the line search stalls for singular M with many multipliers. Steps are halved
/// by Armijo's rule for \f$ |\varphi|^2/2 \f$. If the Newton step does not descend, the negative
/// gradient is the step.
/// @param  options  default limit: 100 steps
/// @return          solved or stalled; iterations are steps
/// @par Accuracy    quadratic convergence if z + w > 0 and \f$ M_{AA} \f$ is nonsingular, slower
///                  otherwise; @ref claim_11_7, @ref claim_11_8, @ref claim_11_11
/// @par Cost        2/3 m^3 operations per step
/// @par Not for     proving that there is no solution: the iteration then stalls
/// @sa source: De Luca, Facchinei, Kanzow, Math. Program. 75 (1996) 407
LcpResult fischer_newton(const LcpProblem& problem, const LcpOptions& options = {});

/// Solves (11.2) by Newton's method for the minimum map \f$ h_i = \min(z_i, w_i) = 0 \f$ (11.7).
///
/// Let A be the set of indices with \f$ w_i < z_i \f$. A step makes \f$ w_A \f$ and all other z
/// vanish, by one solve with \f$ M_{AA} \f$. If this block is singular, \f$ 10^{-12} \f$ of the
/// diagonal of M is added to its diagonal. Steps are halved by Armijo's rule for
/// \f$ |h|^2/2 \f$.
/// @param  options  default limit: 100 steps
/// @return          solved or stalled; iterations are steps
/// @par Accuracy    rounding after finitely many steps if the iteration does not stall,
///                  @ref claim_11_9; a chain of m contacts takes m/2 steps, @ref claim_11_6
/// @par Cost        2/3 |A|^3 operations per step
/// @par Not for     singular M, for which the iteration may stall; proving that there is no
///                  solution
/// @sa source: Harker, Pang, Lect. Appl. Math. 26 (1990) 265
LcpResult minimum_map_newton(const LcpProblem& problem, const LcpOptions& options = {});

}  // namespace stokesbook
