#pragma once

#include <functional>
#include <optional>

#include "lcp/problem.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// A direction in which a merit function descends.
struct DescentStep {
  Eigen::VectorXd direction;  ///< of z, m numbers
  double slope;               ///< of the merit function along it, < 0
};

/// A Newton method for a problem without units, given by its merit function and its steps.
struct NewtonMethod {
  /// Returns the merit of a point z with w = q + M z: 0 at a solution, else positive.
  std::function<double(const Eigen::VectorXd& z, const Eigen::VectorXd& w)> merit;
  /// Returns the Newton step from a point z with w = q + M z, or nothing if no step exists there.
  std::function<std::optional<DescentStep>(const LcpProblem& problem, const Eigen::VectorXd& z,
                                           const Eigen::VectorXd& w)>
      step;
};

/// Iterates a Newton method from a guess.
///
/// Each step is halved until the merit function falls by at least \f$ 10^{-4} \f$ of the decrease
/// that its slope predicts (Armijo's rule). Iterations end unsolved when the method has no step, or
/// when the factor of a step falls below \f$ 10^{-12} \f$.
/// @param  method   merit function and steps
/// @param  problem  with m rows
/// @param  options  when to stop, and where to begin; default limit: 100 steps
/// @return          result; its iterations are steps
/// @throws std::invalid_argument when M is not square, or lengths differ
/// @throws std::domain_error when M or q is not finite
LcpResult damped_newton(const NewtonMethod& method, const LcpProblem& problem,
                        const LcpOptions& options);

/// @}

}  // namespace stokesbook
