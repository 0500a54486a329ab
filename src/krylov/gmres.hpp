#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// A linear map of real vectors.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// When to stop.
struct GmresOptions {
  double tolerance = 1e-10;  ///< of the residual's 2-norm, relative to the right-hand side
  int max_iterations = 500;  ///< size of the Krylov space; there is no restart
};

/// Solution and history.
struct GmresResult {
  Eigen::VectorXd solution;  ///< x, as long as b
  int iterations = 0;        ///< dimension of the Krylov space
  int applications = 0;      ///< of A
  bool converged = false;    ///< the recurrence's residual met the tolerance
  double residual = 0.0;     ///< true relative residual |b - A x| / |b|
  std::vector<double>
      history;  ///< relative residual by the recurrence, before and after each iteration
};

/// Solves A x = b by GMRES without restart, preconditioned from the right:
/// \f$ A M^{-1} y = b,\ x = M^{-1} y \f$.
///
/// Right preconditioning leaves the residual that of A x = b. The preconditioned basis is kept and
/// combined (flexible GMRES): what a preconditioner errs by rounding, of relative size
/// \f$ 10^{-7} \f$ where it cancels large loads, then does no harm. The basis is orthogonalised
/// twice (classical Gram-Schmidt, whose two matrix-vector products are fast and exact enough when
/// repeated), so that counts do not suffer from lost orthogonality at 1e-12. Eigen's GMRES
/// (unsupported module) was not used: it has no residual history, restarts by default, and
/// preconditions from the left, so that its tolerance would depend on the preconditioner.
/// @param  apply         x -> A x
/// @param  precondition  r -> M^{-1} r; empty: none
/// @param  b             right-hand side, finite
/// @param  options       when to stop
/// @param  guess         x_0, where the iteration begins, which goes on with
///                       \f$ A d = b - A x_0 \f$; empty, or no better than zero: zero
/// @return               solution and history; a solution that has not converged is returned too
/// @throws std::domain_error when b or A x is not finite, or when the solution does not have the
///                residual that the recurrence converged to, as A is singular to rounding
/// @par Accuracy  residuals by the recurrence and true ones agree to rounding, @ref claim_05_7; of
/// the reduced form, error and tolerance within a factor 10, @ref claim_05_23
/// @par Cost      k + 1 applications of the operator, one more with a guess, k of the
/// preconditioner, 4 n k^2 operations and n k numbers of memory for k
/// iterations, 2 n k with a preconditioner
/// @sa source: Saad, Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856; Saad, SIAM J. Sci. Comput.
/// 14 (1993) 461
GmresResult gmres(const LinearMap& apply, const LinearMap& precondition, const Eigen::VectorXd& b,
                  const GmresOptions& options, const Eigen::VectorXd& guess = {});

/// @}

}  // namespace stokesbook
