#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Units of the unknowns: \f$ z_i = a s_i z'_i \f$.
struct LcpUnits {
  Eigen::VectorXd scale;  ///< s_i > 0, see lcp_residual()
  double size = 1.0;      ///< \f$ a = \max_i |s_i q_i| \f$, or 1 where q = 0
};

/// A problem without units, on which all solvers work, so that their tolerances and counts do not
/// depend on units: \f$ M'_{ij} = s_i M_{ij} s_j \f$ with ones on the diagonal where it was
/// positive, and \f$ q'_i = s_i q_i / a \f$, at most 1.
struct ScaledLcp {
  LcpProblem problem;  ///< without units
  LcpUnits units;      ///< that it had
};

/// Checks that a problem is one.
///
/// @param  problem  any
/// @throws std::invalid_argument when M is not square or q not as long
/// @throws std::domain_error when M or q is not finite
void require_valid(const LcpProblem& problem);

/// Chooses the units.
///
/// @param  diagonal  of M, m numbers
/// @param  largest   stands for entries of the diagonal that are not positive
/// @param  offset    q, m numbers
/// @return           units
LcpUnits lcp_units(const Eigen::VectorXd& diagonal, double largest, const Eigen::VectorXd& offset);

/// Removes the units.
///
/// @param  problem  any
/// @return          the same without units
/// @throws std::invalid_argument as require_valid() does
/// @throws std::domain_error as require_valid() does
ScaledLcp scale_problem(const LcpProblem& problem);

/// Begins at the guess, without units.
///
/// @param  units  of m unknowns
/// @param  guess  m numbers, or empty: zero
/// @return        z' >= 0
/// @throws std::invalid_argument when the guess has another length
Eigen::VectorXd scaled_guess(const LcpUnits& units, const Eigen::VectorXd& guess);

/// Residual at which iterations diverge; that of z = 0 is at most 1.
inline constexpr double diverging_residual = 1e8;

/// Measures \f$ \max_i |\min(z_i, w_i)| \f$.
///
/// @param  z  m numbers
/// @param  w  m numbers
/// @return    0 at a solution; infinite where z or w is not finite
double natural_residual(const Eigen::VectorXd& z, const Eigen::VectorXd& w);

/// Gives a point its units, and judges it: solved when its residual meets the tolerance.
///
/// @param  units      of m unknowns
/// @param  z          without units, >= 0
/// @param  w          of z
/// @param  tolerance  of the residual
/// @return            result, solved or stalled
LcpResult judge(const LcpUnits& units, const Eigen::VectorXd& z, const Eigen::VectorXd& w,
                double tolerance);

/// Judges the point whose entries below zero are zero.
///
/// @param  scaled     problem without units
/// @param  z          without units
/// @param  tolerance  of the residual
/// @return            result, solved or stalled
LcpResult judge(const ScaledLcp& scaled, const Eigen::VectorXd& z, double tolerance);

/// @}

}  // namespace stokesbook
