#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Units of the unknowns: \f$ z_i = a s_i z'_i \f$ with z' without units.
struct LcpUnits {
  Eigen::VectorXd scale;  ///< s_i > 0, see lcp_residual()
  double size = 1.0;      ///< \f$ a = \max_i |s_i q_i| \f$, or 1 where q = 0
};

/// A problem without units: \f$ M'_{ij} = s_i M_{ij} s_j,\ q'_i = s_i q_i / a \f$.
///
/// \f$ M'_{ii} = 1 \f$ where \f$ M_{ii} > 0 \f$, and \f$ |q'_i| \le 1 \f$. All solvers work on such
/// a problem, so that their tolerances and iteration counts do not depend on units.
struct ScaledLcp {
  LcpProblem problem;  ///< M' and q'
  LcpUnits units;      ///< s and a
};

/// Checks the sizes and the numbers of a problem.
///
/// @param  problem  to check
/// @throws std::invalid_argument when M is not square, or q has another length
/// @throws std::domain_error when M or q is not finite
void require_valid(const LcpProblem& problem);

/// Computes \f$ s_i = M_{ii}^{-1/2} \f$ and \f$ a = \max_i |s_i q_i| \f$.
///
/// @param  diagonal  of M, m numbers
/// @param  largest   replaces the entries of the diagonal that are not positive
/// @param  offset    q, m numbers
/// @return           s and a; a = 1 if q = 0, and s_i = 1 if no positive number is available
LcpUnits lcp_units(const Eigen::VectorXd& diagonal, double largest, const Eigen::VectorXd& offset);

/// Removes the units from a problem.
///
/// @param  problem  in any units
/// @return          the same problem without units
/// @throws std::invalid_argument as require_valid() does
/// @throws std::domain_error as require_valid() does
ScaledLcp scale_problem(const LcpProblem& problem);

/// Removes the units from a guess, and sets its negative entries to zero.
///
/// @param  units  of m unknowns
/// @param  guess  of z, m numbers; empty: zero
/// @return        z' >= 0, m numbers
/// @throws std::invalid_argument when the guess has another length
Eigen::VectorXd scaled_guess(const LcpUnits& units, const Eigen::VectorXd& guess);

/// An iteration whose residual exceeds this number diverges and is stopped. The residual of z = 0
/// is at most 1.
inline constexpr double diverging_residual = 1e8;

/// Computes the natural residual \f$ \max_i |\min(z_i, w_i)| \f$ of a problem without units.
///
/// @param  z  m numbers
/// @param  w  of z, m numbers
/// @return    0 at a solution; infinite where z or w is not finite
double natural_residual(const Eigen::VectorXd& z, const Eigen::VectorXd& w);

/// Makes a result of a point z': restores its units, computes its residual, and sets the status to
/// solved if the residual meets the tolerance.
///
/// @param  units      of m unknowns
/// @param  z          without units, m numbers >= 0
/// @param  w          of z, without units, m numbers
/// @param  tolerance  of the residual
/// @return            result, solved or stalled
LcpResult judge(const LcpUnits& units, const Eigen::VectorXd& z, const Eigen::VectorXd& w,
                double tolerance);

/// Makes a result of the point max(z', 0).
///
/// @param  scaled     problem without units
/// @param  z          without units, m numbers
/// @param  tolerance  of the residual
/// @return            result, solved or stalled
LcpResult judge(const ScaledLcp& scaled, const Eigen::VectorXd& z, double tolerance);

/// @}

}  // namespace stokesbook
