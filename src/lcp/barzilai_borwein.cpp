// Solves a linear complementarity problem by projected gradients with the step lengths of Barzilai
// and Borwein (section "Sweeps and gradients" of chapter 11). The method requires only products
// with M.
#include "lcp/barzilai_borwein.hpp"

#include <stdexcept>
#include <string>

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

constexpr int default_products = 2000;

// Projects the gradient w of (11.3): a positive w_i is dropped at z_i = 0, where z_i cannot fall.
VectorXd projected_gradient(const VectorXd& z, const VectorXd& w) {
  return (z.array() > 0.0).select(w, w.cwiseMin(0.0));
}

// Returns s.s / s.y and s.y / y.y in turn, with the changes s of z and y of w. Returns the length
// of the step before if M is zero along s.
double step_length(const VectorXd& s, const VectorXd& y, int turn, double before) {
  const double curvature = s.dot(y);
  if (!(curvature > 0.0)) return before;
  return turn % 2 == 0 ? s.squaredNorm() / curvature : curvature / y.squaredNorm();
}

}  // namespace

LcpResult matrix_free_barzilai_borwein(const LcpOperator& problem, const LcpOptions& options) {
  const auto m = problem.offset.size();
  if (problem.diagonal.size() != 0 && problem.diagonal.size() != m) {
    throw std::invalid_argument("the diagonal has " + std::to_string(problem.diagonal.size()) +
                                " entries, but the offset has " + std::to_string(m));
  }
  const VectorXd diagonal = problem.diagonal.size() == 0 ? VectorXd::Ones(m) : problem.diagonal;
  const LcpScaling scaling =
      compute_scaling(diagonal, m > 0 ? diagonal.cwiseAbs().maxCoeff() : 0.0, problem.offset);
  const auto gradient = [&](const VectorXd& z) {
    const VectorXd product = problem.apply(scaling.size * scaling.scale.cwiseProduct(z));
    const VectorXd w = (product + problem.offset).cwiseProduct(scaling.scale) / scaling.size;
    if (!w.allFinite()) {
      throw std::domain_error(
          "M z + q of the complementarity problem has an entry that is not finite");
    }
    return w;
  };

  VectorXd z = scale_guess(scaling, options.guess);
  VectorXd w = gradient(z);
  int products = 1;
  double residual = natural_residual(z, w);
  LcpResult best = make_result(scaling, z, w, options.tolerance);
  double length = 1.0 / projected_gradient(z, w).lpNorm<Eigen::Infinity>();
  while (residual > options.tolerance && residual < diverging_residual &&
         products < options.max_iterations.value_or(default_products)) {
    // z <- max(0, z - alpha w)
    const VectorXd next_z = (z - length * w).cwiseMax(0.0);
    const VectorXd next_w = gradient(next_z);
    ++products;
    length = step_length(next_z - z, next_w - w, products, length);
    z = next_z;
    w = next_w;
    residual = natural_residual(z, w);
    if (residual < best.residual) best = make_result(scaling, z, w, options.tolerance);
  }
  best.iterations = products;
  return best;
}

LcpResult barzilai_borwein(const LcpProblem& problem, const LcpOptions& options) {
  require_valid(problem);
  return matrix_free_barzilai_borwein(
      LcpOperator{[&](const VectorXd& z) -> VectorXd { return problem.matrix * z; }, problem.offset,
                  problem.matrix.diagonal()},
      options);
}

}  // namespace stokesbook
