// Solves a linear complementarity problem by Newton's method for Fischer's function (11.7), with
// the Jacobian (11.8).
#include "lcp/fischer_newton.hpp"

#include <Eigen/LU>

#include "lcp/damped_newton.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double slope_shift = 1e-6;  // largest shift of the Jacobian's diagonal, where M_ii = 1

// Evaluates Fischer's function phi_i = sqrt(z_i^2 + w_i^2) - z_i - w_i (11.7).
VectorXd fischer(const VectorXd& z, const VectorXd& w) {
  return (z.array().square() + w.array().square()).sqrt() - z.array() - w.array();
}

//! [jacobian]
// Returns D_a + D_b M (11.8). At z_i = w_i = 0 it is the limit along z = (1, ..., 1).
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

}  // namespace

LcpResult fischer_newton(const LcpProblem& problem, const LcpOptions& options) {
  return damped_newton({fischer_merit, fischer_step}, problem, options);
}

}  // namespace stokesbook
