#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// Solves (11.2) by Lemke's complementary pivoting: follows the solutions of
/// \f$ w = q + M z + t e,\ e = (1, \dots, 1) \f$ (11.4) from large t down to t = 0.
///
/// The problem is scaled to \f$ M_{ii} = 1 \f$. Along the path z_i or w_i is zero for every i, and
/// both are zero for one i; the variable that enters the basis is the complement of the one that
/// left it before. Ties of the ratio test are broken lexicographically, so that degenerate problems
/// do not cycle. At the end \f$ M_{AA} z_A = -q_A \f$ is solved for the set A that pivoting found.
/// If rounding has put an index with z = w = 0 on the wrong side of A, the index changes sides.
///
/// If the path ends in a ray, the direction v >= 0 of the ray is returned (11.5). For M positive
/// semidefinite, symmetric or not, v proves that there is no solution: \f$ M^T v \le 0 \f$, but
/// \f$ q \cdot v < 0 \f$. For other M the ray proves nothing.
/// @param  options  the guess is not used; default limit: 50000 + 20 m pivots
/// @return          solved, ray, or stalled at the limit; iterations are pivots
/// @par Accuracy    rounding, times the condition number of \f$ M_{AA} \f$; @ref claim_11_10,
///                  @ref claim_11_12; rays: @ref claim_11_3
/// @par Cost        2 m^2 operations per pivot, memory for m^2 numbers; mostly fewer than 2 m
///                  pivots, but some problems take 2^m, @ref claim_11_1
/// @par Not for     m beyond a thousand: use barzilai_borwein()
/// @sa source: Cottle, Pang, Stone, The Linear Complementarity Problem (1992), 4.4 and 4.9
LcpResult lemke(const LcpProblem& problem, const LcpOptions& options = {});

}  // namespace stokesbook
