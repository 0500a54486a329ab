// Implements naive and published methods for comparison with the library: enumeration of all
// contact sets, an equation whose negative results are set to zero, sweeps, Fischer's Newton method
// without safeguards (11.7), (11.8), and a contact loop in increments.
#include "variants.hpp"

#include "lcp/scaled_problem.hpp"
#include "support/dense.hpp"

namespace stokesbook::verification::lcp {

LcpResult try_all_sets(const LcpProblem& problem) {
  const auto& [matrix, offset] = problem;
  const Index m = offset.size();
  LcpResult result{.z = VectorXd::Zero(m), .residual = lcp_residual(problem, VectorXd::Zero(m))};
  if (m > 12) return result;
  for (unsigned set = 0; set < 1u << m; ++set) {
    std::vector<Index> active;
    for (Index i = 0; i < m; ++i) {
      if (set >> i & 1u) active.push_back(i);
    }
    VectorXd z = VectorXd::Zero(m);
    if (!active.empty()) z(active) = -test::solve(matrix(active, active), offset(active));
    ++result.iterations;
    if (!z.allFinite() || z.minCoeff() < 0.0) continue;
    const double residual = lcp_residual(problem, z);
    if (residual < result.residual) {
      result.residual = residual;
      result.z = z;
    }
    if (residual <= 1e-10) {
      result.status = LcpStatus::solved;
      break;
    }
  }
  return result;
}

VectorXd clipped_equation(const LcpProblem& problem) {
  const VectorXd z = test::least_squares(problem.matrix, -problem.offset);
  return z.cwiseMax(0.0);
}

VectorXd swept(const LcpProblem& problem, int sweeps, bool in_turn) {
  const auto& [matrix, offset] = problem;
  VectorXd z = VectorXd::Zero(offset.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const VectorXd old = z;
    for (Index i = 0; i < z.size(); ++i) {
      const double w = offset[i] + matrix.row(i).dot(in_turn ? z : old);
      z[i] = std::max(0.0, z[i] - w / matrix(i, i));
    }
  }
  return z;
}

double true_radius(double z, double w) {
  return std::hypot(z, w);
}

double published_radius(double z, double w) {
  return std::sqrt(std::abs(z + w));
}

VectorXd bare_fischer(const LcpProblem& problem, VectorXd z, const Radius& radius, int steps) {
  for (int step = 0; step < steps && z.allFinite(); ++step) {
    const VectorXd w = problem.offset + problem.matrix * z;
    const VectorXd phi = (z.array().square() + w.array().square()).sqrt() - z.array() - w.array();
    MatrixXd jacobian = problem.matrix;
    for (Index i = 0; i < z.size(); ++i) {
      const double r = std::max(radius(z[i], w[i]), 1e-300);
      jacobian.row(i) *= w[i] / r - 1.0;
      jacobian(i, i) += z[i] / r - 1.0;
    }
    z -= test::solve(jacobian, phi);
  }
  return z;
}

VectorXd step_by_sign_of_z(const LcpProblem& problem, const VectorXd& z) {
  std::vector<Index> active;
  for (Index i = 0; i < z.size(); ++i) {
    if (z[i] > 0.0) active.push_back(i);
  }
  VectorXd next = VectorXd::Zero(z.size());
  next(active) = -test::solve(problem.matrix(active, active), problem.offset(active));
  return next;
}

Increments increments(const ContactStep& step, int iterations) {
  VectorXd velocity = step.free_velocity, total;
  ContactRows rows = step.rows(velocity);
  total = VectorXd::Zero(rows.gap.size());
  for (int k = 0; k < iterations && rows.gap.minCoeff() < -step.tolerance; ++k) {
    const MatrixXd response = step.respond(rows.gradient.transpose());
    const LcpProblem problem{step.dt * (rows.gradient * response), rows.gap};
    const VectorXd increment = lemke(problem).z;
    total += increment;
    velocity += response * increment;
    rows = step.rows(velocity);
  }
  double residual = std::max(0.0, -rows.gap.minCoeff());
  for (Index i = 0; i < total.size(); ++i) {
    if (total[i] > 0.0) residual = std::max(residual, rows.gap[i]);
  }
  return {velocity, residual};
}

}  // namespace stokesbook::verification::lcp
