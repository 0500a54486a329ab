#include "lcp/minimum_map_newton.hpp"

#include <vector>

#include <Eigen/LU>

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int default_steps = 100;
constexpr double armijo = 1e-4;
constexpr double shortest = 1e-12;        // factor of a step
constexpr double regularisation = 1e-12;  // of a singular block
constexpr double singular = 1e-14;        // reciprocal condition

VectorXd solve_block(MatrixXd block, const VectorXd& rhs) {
  const Eigen::PartialPivLU<MatrixXd> lu(block);
  if (lu.rcond() > singular) return lu.solve(rhs);
  block.diagonal().array() += regularisation;
  return block.partialPivLu().solve(rhs);
}

// Where z + step has w_A = 0, and all other z = 0.
VectorXd newton_step(const LcpProblem& problem, const VectorXd& z, const VectorXd& w) {
  std::vector<Index> active;
  for (Index i = 0; i < z.size(); ++i) {
    if (w[i] < z[i]) active.push_back(i);
  }
  VectorXd next = VectorXd::Zero(z.size());
  if (!active.empty()) {
    next(active) = solve_block(problem.matrix(active, active), -problem.offset(active));
  }
  return next - z;
}

double merit(const VectorXd& z, const VectorXd& w) {
  return 0.5 * z.cwiseMin(w).squaredNorm();
}

}  // namespace

LcpResult minimum_map_newton(const LcpProblem& problem, const LcpOptions& options) {
  const ScaledLcp scaled = scale_problem(problem);
  const auto& [matrix, offset] = scaled.problem;
  VectorXd z = scaled_guess(scaled.units, options.guess);
  VectorXd w = offset + matrix * z;
  const int most = options.max_iterations.value_or(default_steps);
  int steps = 0;
  LcpResult result = judge(scaled, z, options.tolerance);
  while (result.status != LcpStatus::solved && steps < most) {
    const VectorXd step = newton_step(scaled.problem, z, w);
    if (!step.allFinite()) break;
    const double now = merit(z, w);
    double factor = 1.0;
    VectorXd next_z, next_w;
    for (; factor > shortest; factor *= 0.5) {
      next_z = z + factor * step;
      next_w = offset + matrix * next_z;
      if (merit(next_z, next_w) <= (1.0 - 2.0 * armijo * factor) * now) break;
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
