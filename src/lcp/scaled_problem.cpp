// Removes the units from a linear complementarity problem, and measures residuals of the problem
// without units (chapter 11, "Units").
#include "lcp/scaled_problem.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Scaled z and w below this number are taken for zero: rounding has changed them, and the scaled q
// has entries up to 1.
constexpr double zero = 1e-9;

}  // namespace

void require_valid(const LcpProblem& problem) {
  const Index m = problem.offset.size();
  if (problem.matrix.rows() != m || problem.matrix.cols() != m) {
    throw std::invalid_argument(
        "M must be m x m with m = " + std::to_string(m) + " entries in the offset, not " +
        std::to_string(problem.matrix.rows()) + " x " + std::to_string(problem.matrix.cols()));
  }
  if (!problem.matrix.allFinite() || !problem.offset.allFinite()) {
    throw std::domain_error(
        "the matrix or the offset of a complementarity problem has an entry that is not finite");
  }
}

LcpScaling compute_scaling(const VectorXd& diagonal, double largest, const VectorXd& offset) {
  LcpScaling scaling;
  // s_i = M_ii^(-1/2)
  scaling.scale = diagonal.unaryExpr([&](double entry) {
    const double used = entry > 0.0 ? entry : largest;
    return used > 0.0 ? 1.0 / std::sqrt(used) : 1.0;
  });
  if (offset.size() > 0) {
    // a = max_i |s_i q_i|
    const double size = scaling.scale.cwiseProduct(offset).cwiseAbs().maxCoeff();
    if (size > 0.0) scaling.size = size;
  }
  return scaling;
}

ScaledLcp scale_problem(const LcpProblem& problem) {
  require_valid(problem);
  const auto& [matrix, offset] = problem;
  const double largest = matrix.size() > 0 ? matrix.cwiseAbs().maxCoeff() : 0.0;
  ScaledLcp scaled{{}, compute_scaling(matrix.diagonal(), largest, offset)};
  const auto& scale = scaled.scaling.scale;
  // M'_ij = s_i M_ij s_j and q'_i = s_i q_i / a
  scaled.problem.matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
  scaled.problem.offset = scale.cwiseProduct(offset) / scaled.scaling.size;
  return scaled;
}

VectorXd scale_guess(const LcpScaling& scaling, const VectorXd& guess) {
  const Index m = scaling.scale.size();
  if (guess.size() == 0) return VectorXd::Zero(m);
  if (guess.size() != m) {
    throw std::invalid_argument("the guess has " + std::to_string(guess.size()) +
                                " numbers, but the problem has " + std::to_string(m) + " rows");
  }
  return guess.cwiseQuotient(scaling.size * scaling.scale).cwiseMax(0.0);
}

double natural_residual(const VectorXd& z, const VectorXd& w) {
  // Eigen's maxCoeff() may skip a NaN, so test for finite numbers first.
  if (!z.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  return z.size() == 0 ? 0.0 : z.cwiseMin(w).cwiseAbs().maxCoeff();
}

LcpResult make_result(const LcpScaling& scaling, const VectorXd& z, const VectorXd& w,
                      double tolerance) {
  LcpResult result;
  result.z = scaling.size * scaling.scale.cwiseProduct(z);
  result.residual = natural_residual(z, w);
  result.status = result.residual <= tolerance ? LcpStatus::solved : LcpStatus::stalled;
  result.degenerate = static_cast<int>((z.array().max(w.array().abs()) <= zero).count());
  return result;
}

LcpResult make_result(const ScaledLcp& scaled, const VectorXd& z, double tolerance) {
  const VectorXd positive = z.cwiseMax(0.0);
  return make_result(scaled.scaling, positive,
                     scaled.problem.offset + scaled.problem.matrix * positive, tolerance);
}

double lcp_residual(const LcpProblem& problem, const VectorXd& z) {
  const ScaledLcp scaled = scale_problem(problem);
  const VectorXd unitless = z.cwiseQuotient(scaled.scaling.size * scaled.scaling.scale);
  return natural_residual(unitless, scaled.problem.offset + scaled.problem.matrix * unitless);
}

}  // namespace stokesbook
