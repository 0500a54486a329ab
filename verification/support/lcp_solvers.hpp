#pragma once

#include "lcp/barzilai_borwein.hpp"
#include "lcp/lemke.hpp"
#include "lcp/newton.hpp"
#include "lcp/projected_gauss_seidel.hpp"
#include "support/lcp_problems.hpp"

namespace stokesbook::test {

/// Holds a solver and its name in messages.
struct NamedSolver {
  const char* name;
  LcpSolver solve;
};

inline const std::vector<NamedSolver>& solvers() {
  static const std::vector<NamedSolver> all{{"Lemke", lemke},
                                            {"Fischer-Newton", fischer_newton},
                                            {"minimum-map Newton", minimum_map_newton},
                                            {"projected Gauss-Seidel", projected_gauss_seidel},
                                            {"Barzilai-Borwein", barzilai_borwein}};
  return all;
}

inline bool solved(const LcpResult& result) {
  return result.status == LcpStatus::solved;
}

inline MatrixXd matrix2(double a, double b, double c, double d) {
  return (MatrixXd(2, 2) << a, b, c, d).finished();
}

inline VectorXd vector2(double a, double b) {
  return (VectorXd(2) << a, b).finished();
}

inline VectorXd vector3(double a, double b, double c) {
  return (VectorXd(3) << a, b, c).finished();
}

inline double largest(const VectorXd& v) {
  return v.cwiseAbs().maxCoeff();
}

/// Returns whether v proves that a positive semidefinite problem has no solution (11.5):
/// v >= 0, M^T v <= 0 and q . v < 0.
inline bool proves_no_solution(const VectorXd& v, const LcpProblem& problem) {
  if (v.size() != problem.offset.size()) return false;
  const double size = largest(v) * problem.matrix.cwiseAbs().maxCoeff();
  return v.minCoeff() >= 0.0 && (problem.matrix.transpose() * v).maxCoeff() <= 1e-10 * size &&
         problem.offset.dot(v) < -1e-10 * largest(v) * largest(problem.offset);
}

}  // namespace stokesbook::test
