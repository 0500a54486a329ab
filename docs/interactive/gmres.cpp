// Chapter 05: the residuals of GMRES, and its polynomial at given eigenvalues.
#include "krylov/gmres.hpp"

#include <array>
#include <cmath>

#include "interactive/numbers.hpp"
#include "support/spectra.hpp"

namespace {

interactive::Case gmres_case(const std::array<std::array<double, 2>, 5>& eigenvalues,
                             double coupling, int k) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(10, 10);
  Eigen::VectorXd b(10);
  interactive::Numbers settings{{"coupling", coupling}, {"k", k}};
  for (int j = 0; j < 5; ++j) {
    const auto [x, y] = eigenvalues[static_cast<std::size_t>(j)];
    a.block<2, 2>(2 * j, 2 * j) << x, -y, y, x;
    if (j < 4) a.block<2, 2>(2 * j, 2 * j + 2) = coupling * Eigen::Matrix2d::Identity();
    b.segment<2>(2 * j) << std::sqrt(0.2), 0.0;
    settings.emplace_back("x" + std::to_string(j), x);
    settings.emplace_back("y" + std::to_string(j), y);
  }
  const auto apply = [&a](const Eigen::VectorXd& v) -> Eigen::VectorXd { return a * v; };
  const auto result = stokesbook::gmres(apply, {}, b, {.tolerance = 1e-14, .max_iterations = k});
  // r = p(A) b. With a left eigenvector y, A^T y = lambda y, and so p(lambda) = y^T r / y^T b.
  const Eigen::MatrixXcd left = stokesbook::test::eigenpairs(a.transpose()).vectors.transpose();
  const Eigen::VectorXd r = b - a * result.solution;
  const Eigen::VectorXd p = (left * r).cwiseQuotient(left * b).cwiseAbs();
  return {.settings = settings,
          .numbers = {{"residual", result.history.back()},
                      {"mean", p.norm() / std::sqrt(10.0)},
                      {"largest", p.maxCoeff()}}};
}

}  // namespace

std::vector<interactive::Case> interactive::gmres() {
  return {gmres_case({{{1.4, 0.1}, {1.3, 0.4}, {1.0, 0.5}, {0.7, 0.4}, {0.5, 0.2}}}, 0.0, 5),
          gmres_case({{{-0.5, 0.3}, {1.3, 0.4}, {1.0, 0.5}, {2.2, 0.1}, {0.2, 0.9}}}, 0.0, 7),
          gmres_case({{{1.4, 0.1}, {1.1, 0.2}, {1.0, 0.4}, {0.8, 0.3}, {0.6, 0.2}}}, 0.6, 4)};
}
