// Solves a linear complementarity problem by Newton's method for the minimum map min(z_i, w_i) = 0
// (11.7).
#include "lcp/minimum_map_newton.hpp"

#include <vector>

#include <Eigen/LU>

#include "lcp/damped_newton.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double block_shift = 1e-12;  // added to the diagonal of a singular block, where M_ii = 1
constexpr double singular = 1e-14;     // reciprocal condition number of a singular block

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

LcpResult minimum_map_newton(const LcpProblem& problem, const LcpOptions& options) {
  return damped_newton({minimum_map_merit, minimum_map_step}, problem, options);
}

}  // namespace stokesbook
