#pragma once

#include <Eigen/Core>

#include "closure/bordered_system.hpp"
#include "support/spectra.hpp"

namespace stokesbook::test {

/// Scales the matrix of a problem's dense system, so that the 2-norm of the result is the norm of
/// the original matrix between mean-square norms. The rows of each node are multiplied, and its
/// columns are divided, by the square root of the node's share of the curve's length. The unknowns
/// and rows of a border are not scaled.
inline Eigen::MatrixXd between_mean_squares(Eigen::MatrixXd matrix, const StokesProblem& problem) {
  Eigen::Index row = 0;
  for (const Component& component : problem.components) {
    const Eigen::VectorXd w = weights(component.curve);
    for (Eigen::Index j = 0; j < w.size(); ++j, row += 2) {
      const double scale = std::sqrt(w[j] / w.sum());
      matrix.middleRows(row, 2) *= scale;
      matrix.middleCols(row, 2) /= scale;
    }
  }
  return matrix;
}

/// Returns the condition number of a problem's dense matrix between mean-square norms.
inline double mean_square_condition(const Eigen::MatrixXd& matrix, const StokesProblem& problem) {
  return condition_number(between_mean_squares(matrix, problem));
}

inline double mean_square_condition(const StokesProblem& problem, ClosureForm form) {
  return mean_square_condition(assemble(problem, form).matrix, problem);
}

}  // namespace stokesbook::test
