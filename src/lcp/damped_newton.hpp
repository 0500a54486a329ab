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

/// A Newton's method for a problem without units, as its merit function and its steps say.
struct NewtonMethod {
  /// Merit of a point z with w = q + M z: 0 at a solution.
  std::function<double(const Eigen::VectorXd& z, const Eigen::VectorXd& w)> merit;
  /// Step from a point of this merit; none where there is none.
  std::function<std::optional<DescentStep>(const LcpProblem& problem, const Eigen::VectorXd& z,
                                           const Eigen::VectorXd& w)>
      step;
};

/// Iterates with steps halved until the merit function descends by a part of what its slope
/// promises (Armijo); 100 steps unless the options say otherwise.
///
/// @param  method   merit and steps
/// @param  problem  any
/// @param  options  when to stop, and where to begin
/// @return          result; its iterations are steps
/// @throws std::invalid_argument when M is not square, or lengths differ
/// @throws std::domain_error when M or q is not finite
LcpResult damped_newton(const NewtonMethod& method, const LcpProblem& problem,
                        const LcpOptions& options);

/// @}

}  // namespace stokesbook
