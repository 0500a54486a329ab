#include "lcp/fischer_newton.hpp"

#include <Eigen/LU>

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int default_steps = 100;
constexpr double armijo = 1e-4;
constexpr double shortest = 1e-12;       // factor of a step
constexpr double regularisation = 1e-6;  // beside M_ii = 1

VectorXd fischer(const VectorXd& z, const VectorXd& w) {
  return (z.array().square() + w.array().square()).sqrt() - z.array() - w.array();
}

//! [jacobian]
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
//! [jacobian]

}  // namespace

LcpResult fischer_newton(const LcpProblem& problem, const LcpOptions& options) {
  const ScaledLcp scaled = scale_problem(problem);
  const auto& [matrix, offset] = scaled.problem;
  VectorXd z = scaled_guess(scaled.units, options.guess);
  VectorXd w = offset + matrix * z;
  const int most = options.max_iterations.value_or(default_steps);
  int steps = 0;
  LcpResult result = judge(scaled, z, options.tolerance);
  while (result.status != LcpStatus::solved && steps < most) {
    const VectorXd phi = fischer(z, w);
    const double merit = 0.5 * phi.squaredNorm();
    MatrixXd slope = jacobian(matrix, z, w);
    const VectorXd gradient = slope.transpose() * phi;
    slope.diagonal().array() -= std::min(regularisation, phi.norm());
    VectorXd direction = -slope.partialPivLu().solve(phi);
    // Newton's slope is -2 merit; a singular Jacobian's is anything.
    if (!direction.allFinite() || !(gradient.dot(direction) < -0.1 * merit)) direction = -gradient;
    const double promised = gradient.dot(direction);

    double factor = 1.0;
    VectorXd next_z, next_w;
    for (; factor > shortest; factor *= 0.5) {
      next_z = z + factor * direction;
      next_w = offset + matrix * next_z;
      if (0.5 * fischer(next_z, next_w).squaredNorm() <= merit + armijo * factor * promised) break;
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
