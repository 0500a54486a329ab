#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Solves by Lemke's complementary pivoting: follows
/// \f$ w = q + M z + t e,\ e = (1, \dots, 1) \f$, from large t down to t = 0.
///
/// The problem is scaled to \f$ M_{ii} = 1 \f$. Along the path one of z_i and w_i is zero for every
/// i, for one i both; the complement of the variable that left the basis enters it. Ties of the
/// ratio test are broken lexicographically, so that degenerate problems do not cycle. At the end
/// \f$ M_{AA} z_A = -q_A \f$ is solved for the set A that pivoting found. Where rounding has put
/// indices with z = w = 0 on the wrong side, they change it.
///
/// Where the path ends in a ray, its direction v >= 0 is returned. For M positive semidefinite,
/// symmetric or not, it proves that there is no solution: \f$ M^T v \le 0 \f$, but
/// \f$ q \cdot v < 0 \f$. For other M it proves nothing.
/// @param  problem  with m rows
/// @param  options  the guess is not used; without a limit, 50000 + 20 m pivots are allowed
/// @return          solution or ray; iterations are pivots
/// @throws std::invalid_argument when sizes do not agree
/// @throws std::domain_error when M or q is not finite
/// @par Accuracy    rounding, times the condition of \f$ M_{AA} \f$; @ref claim_11_10, @ref
///                  claim_11_12; rays: @ref claim_11_3
/// @par Cost        2 m^2 operations a pivot, m^2 numbers of memory; mostly fewer than 2 m pivots,
///                  but there are problems with 2^m, @ref claim_11_1
/// @par Not for     m beyond a thousand: use barzilai_borwein()
/// @sa source: Cottle, Pang, Stone, The Linear Complementarity Problem (1992), 4.4 and 4.9
LcpResult lemke(const LcpProblem& problem, const LcpOptions& options = {});

/// @}

}  // namespace stokesbook
