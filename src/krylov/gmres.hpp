#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace stokesbook {

/// A linear map of real vectors.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Criteria by which gmres() stops.
struct GmresOptions {
  double tolerance = 1e-10;  ///< bound of |b - A x| / |b| in the 2-norm
  int max_iterations = 500;  ///< largest Krylov space; there is no restart
  /// A bound of |A x| / |x|, if one is known. The residual of the solution is then that of the
  /// recurrence, without a product, where rounding errors are below a hundredth of the tolerance.
  double norm = std::numeric_limits<double>::infinity();
};

/// Solution and convergence history of gmres().
struct GmresResult {
  Eigen::VectorXd solution;  ///< x, as long as b
  int iterations = 0;        ///< dimension of the Krylov space
  int applications = 0;      ///< applications of A
  bool converged = false;    ///< the residual of the recurrence meets the tolerance
  double residual = 0.0;     ///< relative residual |b - A x| / |b|
  /// Relative residual by the recurrence, before and after each iteration.
  std::vector<double> history;
};

/// Solves A x = b by GMRES without restart, preconditioned from the right:
/// \f$ A M^{-1} y = b,\ x = M^{-1} y \f$.
///
/// With right preconditioning, the residual is that of A x = b. The solution is combined from the
/// preconditioned basis, which is stored (flexible GMRES). Rounding errors of the preconditioner,
/// of relative size \f$ 10^{-7} \f$ where large loads cancel, then do no harm. The basis is
/// orthogonalised by two passes of classical Gram-Schmidt, which are fast matrix-vector products.
///
/// Eigen's GMRES (unsupported module) is not used, because it has no residual history, restarts by
/// default, and preconditions from the left, so that its tolerance would depend on the
/// preconditioner.
/// @param  precondition  r -> M^{-1} r; empty if there is no preconditioner
/// @param  guess         x_0, from which the iteration solves \f$ A d = b - A x_0 \f$ for the
///                       correction d; if empty or no better than zero, x_0 = 0
/// @return               solution and history; a solution that has not converged is returned too
/// @throws std::domain_error when b or A x is not finite, or when the residual of the solution is
///                not the one to which the recurrence converged, because A is singular to rounding
/// @par Accuracy  the residuals of the recurrence and of the solution agree to rounding,
/// @ref claim_05_7; for the reduced form, the error of the motions is the tolerance within a factor
/// of 10, @ref claim_05_23
/// @par Cost      for k iterations, k + 1 applications of the operator, or k where
/// GmresOptions::norm saves one, and one more with a guess; k of the preconditioner, 4 n k^2
/// operations, and n k numbers of memory, 2 n k with a preconditioner
/// @sa source: Saad, Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856; Saad, SIAM J. Sci. Comput.
/// 14 (1993) 461
GmresResult gmres(const LinearMap& apply, const LinearMap& precondition, const Eigen::VectorXd& b,
                  const GmresOptions& options, const Eigen::VectorXd& guess = {});

}  // namespace stokesbook
