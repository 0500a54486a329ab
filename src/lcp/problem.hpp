#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace stokesbook {

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
  double tolerance = 1e-10;             ///< tolerance of the residual, see lcp_residual()
  std::optional<int> max_iterations{};  ///< empty: the default limit of the solver
  Eigen::VectorXd guess{};              ///< guess of z, m numbers; empty: zero; not used by lemke()
};

/// The result of a solver.
struct LcpResult {
  Eigen::VectorXd z;                      ///< m numbers >= 0; a solution only if solved
  LcpStatus status = LcpStatus::stalled;  ///< how it ended
  int iterations = 0;                     ///< pivots, Newton steps, sweeps, or products with M
  double residual = 0.0;                  ///< residual of z, see lcp_residual()
  int degenerate = 0;                     ///< number of i with z_i = w_i = 0, to 1e-9 when scaled
  Eigen::VectorXd ray{};                  ///< direction of a ray, m numbers >= 0; otherwise empty
};

/// The signature of all solvers: lemke(), fischer_newton(), minimum_map_newton(),
/// projected_gauss_seidel(), barzilai_borwein(). All throw std::invalid_argument when sizes do not
/// agree, and std::domain_error when M or q is not finite.
using LcpSolver = std::function<LcpResult(const LcpProblem&, const LcpOptions&)>;

}  // namespace stokesbook
