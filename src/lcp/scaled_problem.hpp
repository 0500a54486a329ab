#pragma once

#include "lcp/problem.hpp"

namespace stokesbook {

/// The factors of the unknowns: \f$ z_i = a s_i z'_i \f$ with z' without units.
struct LcpScaling {
  Eigen::VectorXd scale;  ///< s_i > 0, see lcp_residual()
  double size = 1.0;      ///< \f$ a = \max_i |s_i q_i| \f$, or 1 where q = 0
};

/// A problem without units: \f$ M'_{ij} = s_iM_{ij}s_j,\ q'_i = s_iq_i/a \f$ with
/// \f$ s_i = M_{ii}^{-1/2},\ a = \max_i|s_iq_i| \f$.
///
/// Every solver works on the problem without units, so that its accuracy and its number of
/// iterations do not depend on the units of single rows.
struct ScaledLcp {
  LcpProblem problem;  ///< M' and q'
  LcpScaling scaling;  ///< s and a
};

/// Checks the sizes and the numbers of a problem.
/// @throws std::invalid_argument when M is not square, or q has another length
/// @throws std::domain_error when M or q is not finite
void require_valid(const LcpProblem& problem);

/// Computes \f$ s_i = M_{ii}^{-1/2} \f$ and \f$ a = \max_i |s_i q_i| \f$ from the diagonal of M and
/// the offset q; a = 1 if q = 0.
///
/// @param  largest   replaces entries of the diagonal that are not positive; if `largest` is not
///                   positive either, s_i = 1
LcpScaling compute_scaling(const Eigen::VectorXd& diagonal, double largest,
                           const Eigen::VectorXd& offset);

/// Removes the units from a problem. Throws as require_valid() does.
ScaledLcp scale_problem(const LcpProblem& problem);

/// Removes the units from a guess of z, and sets its negative entries to zero. An empty guess is
/// zero.
/// @throws std::invalid_argument when the guess has another length
Eigen::VectorXd scale_guess(const LcpScaling& scaling, const Eigen::VectorXd& guess);

/// An iteration whose residual exceeds this number diverges and is stopped. The residual of z = 0
/// is at most 1.
inline constexpr double diverging_residual = 1e8;

/// Computes the natural residual \f$ \max_i |\min(z_i, w_i)| \f$ of a problem without units: 0 at a
/// solution, infinite where z or w is not finite.
double natural_residual(const Eigen::VectorXd& z, const Eigen::VectorXd& w);

/// Makes a result of a point z >= 0 with its w, both without units: restores the units of z,
/// computes its residual, and sets the status to solved if the residual meets the tolerance, else
/// to stalled.
LcpResult make_result(const LcpScaling& scaling, const Eigen::VectorXd& z, const Eigen::VectorXd& w,
                      double tolerance);

/// Makes a result of the point max(z, 0), without units.
LcpResult make_result(const ScaledLcp& scaled, const Eigen::VectorXd& z, double tolerance);

/// Measures by how much z misses a solution:
/// \f$ \max_i |\min(z_i / s_i,\ s_i w_i)| / \max_i |s_i q_i| \f$ with \f$ s_i = M_{ii}^{-1/2} \f$.
///
/// z and w have different units; \f$ z_i / s_i \f$ and \f$ s_i w_i \f$ both have the unit of the
/// square root of a work. The residual does not change if single rows change units,
/// \f$ M \to D M D,\ q \to D q \f$, or if M or q is multiplied by a factor. If
/// \f$ M_{ii} \le 0 \f$, the largest modulus of an entry of M replaces \f$ M_{ii} \f$.
/// @return    0 at a solution; the denominator is 1 if q = 0
/// @par Cost  one product with M
double lcp_residual(const LcpProblem& problem, const Eigen::VectorXd& z);

}  // namespace stokesbook
