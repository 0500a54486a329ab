#pragma once

#include <random>

#include "krylov/gmres.hpp"
#include "support/dense.hpp"

namespace stokesbook::test {

/// Returns a matrix of independent normal deviates, the same in every run.
inline Eigen::MatrixXd normal_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

/// Returns a random orthogonal matrix.
inline Eigen::MatrixXd orthogonal_matrix(Eigen::Index n, unsigned seed) {
  return orthogonal_factor(normal_matrix(n, n, seed));
}

/// Returns a nonsymmetric matrix whose spectrum lies in a disk about 1 that excludes 0.
inline Eigen::MatrixXd well_conditioned_matrix(Eigen::Index n, unsigned seed) {
  return Eigen::MatrixXd::Identity(n, n) +
         0.5 / std::sqrt(static_cast<double>(n)) * normal_matrix(n, n, seed);
}

/// Returns the map v -> matrix v.
inline LinearMap map_of(const Eigen::MatrixXd& matrix) {
  return [matrix](const Eigen::VectorXd& v) -> Eigen::VectorXd { return matrix * v; };
}

/// Returns the relative error that an approximate inverse leaves in a random vector.
inline double inversion_error(const LinearMap& inverse, const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd exact = normal_matrix(matrix.cols(), 1, 3);
  return (inverse(matrix * exact) - exact).norm() / exact.norm();
}

}  // namespace stokesbook::test
