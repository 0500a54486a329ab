#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Linear complementarity problem: find z with
/// \f$ w = q + M z, \quad z \ge 0, \quad w \ge 0, \quad z \cdot w = 0 \f$.
///
/// Where M is symmetric and positive semidefinite, z minimises
/// \f$ \tfrac12 z \cdot M z + q \cdot z \f$ over z >= 0.
struct LcpProblem {
  Eigen::MatrixXd matrix;  ///< M, m x m, finite
  Eigen::VectorXd offset;  ///< q, m numbers, finite
};

/// How a solver ended.
enum class LcpStatus {
  solved,  ///< the residual meets the tolerance
  ray,     ///< Lemke's path left to infinity: no solution where M is positive semidefinite
  stalled  ///< a residual was left when iterations ran out, or a search no longer descended
};

/// When to stop, and where to begin.
struct LcpOptions {
  double tolerance = 1e-10;             ///< of the residual of LcpResult
  std::optional<int> max_iterations{};  ///< none: what the solver allows
  Eigen::VectorXd guess{};              ///< m numbers, or empty: zero; pivoting makes no use of it
};

/// What a solver found.
struct LcpResult {
  Eigen::VectorXd z;                      ///< m numbers >= 0; no solution unless solved
  LcpStatus status = LcpStatus::stalled;  ///< how it ended
  int iterations = 0;                     ///< pivots, Newton steps, sweeps, or products with M
  double residual = 0.0;                  ///< of z, see lcp_residual()
  int degenerate = 0;                     ///< indices where z and w both are zero to 1e-9
  Eigen::VectorXd ray{};                  ///< direction of a ray, m numbers >= 0; otherwise empty
};

/// A solver: lemke(), fischer_newton(), minimum_map_newton(), projected_gauss_seidel(),
/// barzilai_borwein().
using LcpSolver = std::function<LcpResult(const LcpProblem&, const LcpOptions&)>;

/// Measures by how much z misses a solution:
/// \f$ \max_i |\min(z_i / s_i,\ s_i w_i)| / \max_i |s_i q_i| \f$ with \f$ s_i = M_{ii}^{-1/2} \f$.
///
/// z and w have different units; with these s both are square roots of a work. Neither units of
/// single rows, \f$ M \to D M D,\ q \to D q \f$, nor a factor of M or q change the residual. Where
/// \f$ M_{ii} \le 0 \f$, the largest entry of M stands for it.
/// @param  problem  with m rows
/// @param  z        m numbers
/// @return          0 at a solution; where q = 0, not divided by it
/// @par Cost        a product with M
double lcp_residual(const LcpProblem& problem, const Eigen::VectorXd& z);

/// @}

}  // namespace stokesbook
