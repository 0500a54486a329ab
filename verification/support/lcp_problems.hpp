#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "lcp/problem.hpp"

namespace stokesbook::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Holds a problem whose solution is known.
struct PlantedLcp {
  std::string name;
  LcpProblem problem;
  VectorXd z;           ///< a solution
  bool unique = false;  ///< whether z is the only solution
};

/// Returns independent normal deviates, which are the same in every run.
inline MatrixXd normal_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

/// Returns a symmetric matrix with eigenvalues of at least 0.1.
inline MatrixXd definite_matrix(Index m, unsigned seed) {
  const MatrixXd factor = normal_matrix(m, m, seed);
  return factor * factor.transpose() / static_cast<double>(m) + 0.1 * MatrixXd::Identity(m, m);
}

/// Returns a symmetric positive semidefinite matrix of a given rank.
inline MatrixXd semidefinite_matrix(Index m, Index rank, unsigned seed) {
  const MatrixXd factor = normal_matrix(m, rank, seed);
  return factor * factor.transpose() / static_cast<double>(rank);
}

inline MatrixXd hilbert_matrix(Index m) {
  return MatrixXd::NullaryExpr(
      m, m, [](Index i, Index j) { return 1.0 / static_cast<double>(i + j + 1); });
}

/// Returns the tridiagonal matrix (-1, 2, -1), which describes the contacts of a row of disks.
inline MatrixXd chain_matrix(Index m) {
  MatrixXd matrix = 2.0 * MatrixXd::Identity(m, m);
  matrix.diagonal(1).setConstant(-1.0);
  matrix.diagonal(-1).setConstant(-1.0);
  return matrix;
}

/// Returns the problem of a chain that is pushed together at both ends. The solution is z = 1 in
/// every contact.
inline LcpProblem chain(Index m) {
  return {chain_matrix(m), -VectorXd::Unit(m, 0) - VectorXd::Unit(m, m - 1)};
}

/// Returns Murty's problem. The matrix has ones on the diagonal and twos below the diagonal, and
/// q = -1. The solution is z = e_1.
inline LcpProblem murty(Index m) {
  MatrixXd matrix = MatrixXd::Identity(m, m);
  matrix.triangularView<Eigen::StrictlyLower>().setConstant(2.0);
  return {matrix, -VectorXd::Ones(m)};
}

/// Doubles every contact. The two copies of a contact are equal up to 1e-6.
inline MatrixXd near_duplicates(const MatrixXd& matrix) {
  const Index m = matrix.rows();
  MatrixXd result(2 * m, 2 * m);
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < m; ++j) {
      const double near = (1.0 - 1e-6) * matrix(i, j);
      result.block<2, 2>(2 * i, 2 * j) << matrix(i, j), near, near, matrix(i, j);
    }
  }
  return result;
}

/// Returns random factors 10^u with u uniform in (-6, 0).
inline VectorXd random_scale(Index m, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> power(-6.0, 0.0);
  return VectorXd::NullaryExpr(m, [&] { return std::pow(10.0, power(generator)); });
}

/// Returns a problem that has the given matrix and a random solution z. About 30 % of the pairs
/// have z = w = 0. Half of the other pairs have z > 0, and the other half have w > 0.
inline PlantedLcp planted(std::string name, const MatrixXd& matrix, unsigned seed, bool unique) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform;
  VectorXd z = VectorXd::Zero(matrix.rows()), w = z;
  for (Index i = 0; i < z.size(); ++i) {
    const double kind = uniform(generator), value = 0.1 + uniform(generator);
    if (kind < 0.35) z[i] = value;
    if (kind >= 0.65) w[i] = value;
  }
  return {std::move(name), {matrix, w - matrix * z}, z, unique};
}

/// Returns the same problem with each row in a different unit.
inline PlantedLcp in_other_units(const PlantedLcp& lcp, const VectorXd& scale) {
  return {lcp.name + " in mixed units",
          {scale.asDiagonal() * lcp.problem.matrix * scale.asDiagonal(),
           scale.cwiseProduct(lcp.problem.offset)},
          lcp.z.cwiseQuotient(scale),
          lcp.unique};
}

/// Returns twenty problems that have a solution. Some are well conditioned, and others are ill
/// conditioned, singular, degenerate or badly scaled.
inline std::vector<PlantedLcp> suite() {
  std::vector<PlantedLcp> cases;
  for (const Index m : {5, 20, 100}) {
    const auto seed = static_cast<unsigned>(m);
    cases.push_back(planted("definite " + std::to_string(m), definite_matrix(m, seed), seed, true));
    cases.push_back(planted("semidefinite " + std::to_string(m),
                            semidefinite_matrix(m, m / 2 + 1, seed), seed, false));
    cases.push_back(in_other_units(cases[cases.size() - 2], random_scale(m, seed)));
    cases.push_back(in_other_units(cases[cases.size() - 2], random_scale(m, seed)));
  }
  cases.push_back(planted("rank 10 of 40", semidefinite_matrix(40, 10, 1), 1, false));
  cases.push_back(planted("rank 50 of 200", semidefinite_matrix(200, 50, 2), 2, false));
  cases.push_back(planted("Hilbert 6", hilbert_matrix(6), 3, false));
  cases.push_back(planted("Hilbert 12", hilbert_matrix(12), 4, false));
  cases.push_back({"chain 50", chain(50), VectorXd::Ones(50), true});
  cases.push_back({"chain 400", chain(400), VectorXd::Ones(400), true});
  cases.push_back(planted("near duplicates", near_duplicates(definite_matrix(20, 5)), 5, false));
  cases.push_back({"Murty 10", murty(10), VectorXd::Unit(10, 0), true});
  return cases;
}

}  // namespace stokesbook::test
