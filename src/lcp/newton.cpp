// Solves a linear complementarity problem by Newton's method, with steps halved by Armijo's rule,
// for Fischer's function (11.7) with the Jacobian (11.8), or for the minimum map min(z_i, w_i) = 0
// (section "Newton" of chapter 11).
#include "lcp/newton.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int default_steps = 100;
constexpr double armijo = 1e-4;  // least decrease of the merit, relative to the slope's prediction
constexpr double shortest = 1e-12;     // least factor of a step
constexpr double slope_shift = 1e-6;   // largest shift of the Jacobian's diagonal, where M_ii = 1
constexpr double block_shift = 1e-12;  // added to the diagonal of a singular block, where M_ii = 1
constexpr double singular = 1e-14;     // reciprocal condition number of a singular block

// A direction in which the merit descends, and the slope of the merit along it, < 0.
struct DescentStep {
  VectorXd direction;
  double slope;
};

// Returns the merit of a point z with w = q + M z: 0 at a solution, else positive.
using Merit = double (*)(const VectorXd& z, const VectorXd& w);

// Returns the Newton step from a point z with w = q + M z, or nothing if no step exists there.
using NewtonStep = std::optional<DescentStep> (*)(const LcpProblem& problem, const VectorXd& z,
                                                  const VectorXd& w);

// Iterates a Newton method from a guess. Iterations end unsolved when the method has no step, or
// when the factor of a step falls below `shortest`.
LcpResult damped_newton(Merit merit, NewtonStep newton_step, const LcpProblem& problem,
                        const LcpOptions& options) {
  const ScaledLcp scaled = scale_problem(problem);
  const auto& [matrix, offset] = scaled.problem;
  VectorXd z = scale_guess(scaled.scaling, options.guess);
  VectorXd w = offset + matrix * z;
  const int most = options.max_iterations.value_or(default_steps);
  int steps = 0;
  LcpResult result = make_result(scaled, z, options.tolerance);
  while (result.status != LcpStatus::solved && steps < most) {
    const std::optional<DescentStep> step = newton_step(scaled.problem, z, w);
    if (!step) break;
    const double now = merit(z, w);
    // Armijo's rule: halve the step until merit(z + factor d) <= merit(z) + armijo factor slope.
    double factor = 1.0;
    VectorXd next_z, next_w;
    for (; factor > shortest; factor *= 0.5) {
      next_z = z + factor * step->direction;
      next_w = offset + matrix * next_z;
      if (merit(next_z, next_w) <= now + armijo * factor * step->slope) break;
    }
    if (factor <= shortest) break;
    z = next_z;
    w = next_w;
    ++steps;
    result = make_result(scaled, z, options.tolerance);
  }
  result.iterations = steps;
  return result;
}

// Evaluates Fischer's function phi_i = sqrt(z_i^2 + w_i^2) - z_i - w_i (11.7).
VectorXd fischer(const VectorXd& z, const VectorXd& w) {
  return (z.array().square() + w.array().square()).sqrt() - z.array() - w.array();
}

// Returns D_z + D_w M (11.8). At z_i = w_i = 0 it is the limit along z = (1, ..., 1).
MatrixXd jacobian(const MatrixXd& matrix, const VectorXd& z, const VectorXd& w) {
  const Index m = z.size();
  VectorXd by_z(m), by_w(m);
  for (Index i = 0; i < m; ++i) {
    double a = z[i], b = w[i];
    if (a == 0.0 && b == 0.0) {
      a = 1.0;
      b = matrix.row(i).sum();
    }
    const double r = std::hypot(a, b);
    by_z[i] = a / r - 1.0;
    by_w[i] = b / r - 1.0;
  }
  MatrixXd result = by_w.asDiagonal() * matrix;
  result.diagonal() += by_z;
  return result;
}

// Returns |phi|^2 / 2.
double fischer_merit(const VectorXd& z, const VectorXd& w) {
  return 0.5 * fischer(z, w).squaredNorm();
}

// Solves (Jacobian - epsilon) d = -phi with a small shift epsilon of the diagonal.
std::optional<DescentStep> fischer_step(const LcpProblem& problem, const VectorXd& z,
                                        const VectorXd& w) {
  const VectorXd phi = fischer(z, w);
  MatrixXd slope = jacobian(problem.matrix, z, w);
  const VectorXd gradient = slope.transpose() * phi;
  slope.diagonal().array() -= std::min(slope_shift, phi.norm());
  VectorXd direction = -slope.partialPivLu().solve(phi);
  // A Newton step has the slope -|phi|^2 = -2 merit. If the Jacobian is nearly singular, the slope
  // of the computed direction may have any value; the negative gradient always descends.
  const bool descends =
      direction.allFinite() && gradient.dot(direction) < -0.05 * phi.squaredNorm();
  if (!descends) direction = -gradient;
  return DescentStep{direction, gradient.dot(direction)};
}

VectorXd solve_block(MatrixXd block, const VectorXd& rhs) {
  const Eigen::PartialPivLU<MatrixXd> lu(block);
  if (lu.rcond() > singular) return lu.solve(rhs);
  block.diagonal().array() += block_shift;
  return block.partialPivLu().solve(rhs);
}

// Returns |min(z, w)|^2 / 2.
double minimum_map_merit(const VectorXd& z, const VectorXd& w) {
  return 0.5 * z.cwiseMin(w).squaredNorm();
}

// Returns the step to the point with w_A = 0 and all other z = 0: M_AA z_A = -q_A, where A is the
// set of indices with w_i < z_i.
std::optional<DescentStep> minimum_map_step(const LcpProblem& problem, const VectorXd& z,
                                            const VectorXd& w) {
  std::vector<Index> active;
  for (Index i = 0; i < z.size(); ++i) {
    if (w[i] < z[i]) active.push_back(i);
  }
  VectorXd next = VectorXd::Zero(z.size());
  if (!active.empty()) {
    next(active) = solve_block(problem.matrix(active, active), -problem.offset(active));
  }
  const VectorXd direction = next - z;
  if (!direction.allFinite()) return std::nullopt;
  return DescentStep{direction, -2.0 * minimum_map_merit(z, w)};
}

}  // namespace

LcpResult fischer_newton(const LcpProblem& problem, const LcpOptions& options) {
  return damped_newton(fischer_merit, fischer_step, problem, options);
}

LcpResult minimum_map_newton(const LcpProblem& problem, const LcpOptions& options) {
  return damped_newton(minimum_map_merit, minimum_map_step, problem, options);
}

}  // namespace stokesbook
