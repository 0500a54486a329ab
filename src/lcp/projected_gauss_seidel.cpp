// Solves a linear complementarity problem by projected Gauss-Seidel sweeps (section "Sweeps and
// gradients" of chapter 11).
#include "lcp/projected_gauss_seidel.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int default_sweeps = 1000;

void require_positive_diagonal(const LcpProblem& problem) {
  for (Index i = 0; i < problem.offset.size(); ++i) {
    if (problem.matrix(i, i) > 0.0) continue;
    std::ostringstream message;
    message << "projected Gauss-Seidel requires a positive diagonal, but M_ii is "
            << problem.matrix(i, i) << " for i = " << i << "; use lemke()";
    throw std::invalid_argument(message.str());
  }
}

}  // namespace

LcpResult projected_gauss_seidel(const LcpProblem& problem, const LcpOptions& options) {
  const ScaledLcp scaled = scale_problem(problem);
  require_positive_diagonal(problem);
  const auto& [matrix, offset] = scaled.problem;
  // The sweeps read rows of M; in the column-major transpose each row is contiguous.
  const Eigen::MatrixXd transposed = matrix.transpose();
  VectorXd z = scale_guess(scaled.scaling, options.guess);
  int sweeps = 0;
  double residual = natural_residual(z, offset + matrix * z);
  while (residual > options.tolerance && residual < diverging_residual &&
         sweeps < options.max_iterations.value_or(default_sweeps)) {
    // z_i <- max(0, z_i - w_i / M_ii)
    for (Index i = 0; i < z.size(); ++i) {
      const double w = offset[i] + transposed.col(i).dot(z);
      z[i] = std::max(0.0, z[i] - w);  // the scaled M_ii is 1
    }
    residual = natural_residual(z, offset + matrix * z);
    ++sweeps;
  }
  LcpResult result = make_result(scaled, z, options.tolerance);
  result.iterations = sweeps;
  return result;
}

}  // namespace stokesbook
