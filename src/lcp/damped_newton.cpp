// Iterates a Newton method for a linear complementarity problem, with steps halved by Armijo's rule
// (section "Newton" of chapter 11).
#include "lcp/damped_newton.hpp"

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

constexpr int default_steps = 100;
constexpr double armijo = 1e-4;  // least decrease of the merit, relative to the slope's prediction
constexpr double shortest = 1e-12;  // least factor of a step

}  // namespace

LcpResult damped_newton(const NewtonMethod& method, const LcpProblem& problem,
                        const LcpOptions& options) {
  const ScaledLcp scaled = scale_problem(problem);
  const auto& [matrix, offset] = scaled.problem;
  VectorXd z = scaled_guess(scaled.units, options.guess);
  VectorXd w = offset + matrix * z;
  const int most = options.max_iterations.value_or(default_steps);
  int steps = 0;
  LcpResult result = judge(scaled, z, options.tolerance);
  while (result.status != LcpStatus::solved && steps < most) {
    const std::optional<DescentStep> step = method.step(scaled.problem, z, w);
    if (!step) break;
    const double now = method.merit(z, w);
    // Armijo's rule: halve the step until merit(z + factor d) <= merit(z) + armijo factor slope.
    double factor = 1.0;
    VectorXd next_z, next_w;
    for (; factor > shortest; factor *= 0.5) {
      next_z = z + factor * step->direction;
      next_w = offset + matrix * next_z;
      if (method.merit(next_z, next_w) <= now + armijo * factor * step->slope) break;
    }
    if (factor <= shortest) break;
    z = next_z;
    w = next_w;
    ++steps;
    result = judge(scaled, z, options.tolerance);
  }
  result.iterations = steps;
  return result;
}

}  // namespace stokesbook
