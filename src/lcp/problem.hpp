#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Linear complementarity problem: find z with
/// \f$ w = q + M z, \quad z \ge 0, \quad w \ge 0, \quad z \cdot w = 0 \f$ (11.2).
///
/// If M is symmetric and positive semidefinite, z minimises
/// \f$ \tfrac12 z \cdot M z + q \cdot z \f$ over z >= 0 (11.3).
struct LcpProblem {
  Eigen::MatrixXd matrix;  ///< M, m x m, finite
  Eigen::VectorXd offset;  ///< q, m numbers, finite
};

/// How a solver ended.
enum class LcpStatus {
  solved,  ///< the residual meets the tolerance
  ray,     ///< Lemke's path went to infinity: no solution if M is positive semidefinite
  stalled  ///< the limit was reached, or the iteration diverged or made no progress
};

/// Determines when a solver stops, and where it begins.
struct LcpOptions {
  double tolerance = 1e-10;             ///< of the residual, see lcp_residual()
  std::optional<int> max_iterations{};  ///< empty: the default limit of the solver
  Eigen::VectorXd guess{};              ///< of z, m numbers; empty: zero; not used by lemke()
};

/// The result of a solver.
struct LcpResult {
  Eigen::VectorXd z;                      ///< m numbers >= 0; a solution only if solved
  LcpStatus status = LcpStatus::stalled;  ///< how it ended
  int iterations = 0;                     ///< pivots, Newton steps, sweeps, or products with M
  double residual = 0.0;                  ///< of z, see lcp_residual()
  int degenerate = 0;                     ///< number of i with z_i = w_i = 0, to 1e-9 when scaled
  Eigen::VectorXd ray{};                  ///< direction of a ray, m numbers >= 0; otherwise empty
};

/// The signature of all solvers: lemke(), fischer_newton(), minimum_map_newton(),
/// projected_gauss_seidel(), barzilai_borwein().
using LcpSolver = std::function<LcpResult(const LcpProblem&, const LcpOptions&)>;

/// Measures by how much z misses a solution:
/// \f$ \max_i |\min(z_i / s_i,\ s_i w_i)| / \max_i |s_i q_i| \f$ with \f$ s_i = M_{ii}^{-1/2} \f$.
///
/// z and w have different units; \f$ z_i / s_i \f$ and \f$ s_i w_i \f$ both have the unit of the
/// square root of a work. The residual does not change if single rows change units,
/// \f$ M \to D M D,\ q \to D q \f$, or if M or q is multiplied by a factor. If
/// \f$ M_{ii} \le 0 \f$, the largest modulus of an entry of M replaces \f$ M_{ii} \f$.
/// @param  problem  with m rows
/// @param  z        m numbers
/// @return          0 at a solution; the denominator is 1 if q = 0
/// @par Cost        one product with M
double lcp_residual(const LcpProblem& problem, const Eigen::VectorXd& z);

/// @}

}  // namespace stokesbook
