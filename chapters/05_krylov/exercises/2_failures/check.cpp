// Check of exercise 05.2: what the book's GMRES makes of the reader's systems.
#include "chapters/check.hpp"

#include "krylov/gmres.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;

struct System {
  MatrixXd matrix;
  VectorXd rhs;
};

MatrixXd stalling(int n);
System with_history(const std::vector<double>& eigenvalues, const std::vector<double>& residuals);
Eigen::Vector2d misleading(double reported);

namespace {

GmresResult solve(const MatrixXd& matrix, const VectorXd& rhs, const GmresOptions& options) {
  return gmres([&](const VectorXd& v) -> VectorXd { return matrix * v; }, {}, rhs, options);
}

VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

[[noreturn]] void reject(const std::string& what, const std::string& mistake) {
  throw exercise::Rejection{exercise::line("for", what) + exercise::line("mistake", mistake)};
}

void check_stalling(int n) {
  const std::string what = "n = " + std::to_string(n);
  const MatrixXd matrix = stalling(n);
  if (matrix.rows() != n || matrix.cols() != n) reject(what, "the matrix is not n x n");
  const MatrixXd product = matrix.transpose() * matrix;
  if ((product - MatrixXd::Identity(n, n)).norm() > 1e-12) {
    reject(what,
           "the matrix is not orthogonal: its columns are to be of length 1, and "
           "perpendicular to each other");
  }
  const GmresResult result = solve(matrix, VectorXd::Unit(n, 0), {1e-12, n});
  if (result.iterations < n) {
    reject(what, "GMRES is done after " + std::to_string(result.iterations) + " iterations");
  }
  VectorXd expected = VectorXd::Ones(n + 1);
  expected[n] = 0.0;
  expect({.what = what + ": the residuals",
          .got = as_vector(result.history),
          .expected = expected,
          .tolerance = 1e-12});
}

// prod (A - lambda_j), which vanishes by the theorem of Cayley and Hamilton.
double characteristic_value(const MatrixXd& matrix, const std::vector<double>& eigenvalues) {
  MatrixXd product = MatrixXd::Identity(matrix.rows(), matrix.cols());
  double scale = 1.0;
  for (const double eigenvalue : eigenvalues) {
    MatrixXd factor = matrix;
    factor.diagonal().array() -= eigenvalue;
    product *= factor;
    scale *= matrix.norm() + std::abs(eigenvalue);
  }
  return product.norm() / scale;
}

void check_history(const std::string& name, const std::vector<double>& eigenvalues,
                   const std::vector<double>& residuals) {
  const System system = with_history(eigenvalues, residuals);
  const auto n = static_cast<int>(residuals.size());
  if (system.matrix.rows() != n || system.matrix.cols() != n || system.rhs.size() != n) {
    reject(name, "the matrix is not n x n, or the right-hand side has not n entries");
  }
  const VectorXd squares = system.rhs.cwiseAbs2();
  VectorXd components(n);
  for (Index i = 0; i < n; ++i) {
    const double after = i + 1 < n ? residuals[static_cast<std::size_t>(i + 1)] : 0.0;
    components[i] = residuals[static_cast<std::size_t>(i)] - after;
  }
  if (exercise::agree(system.rhs, components, 1e-12)) {
    reject(name,
           "the squares of the residuals differ by the squares of the components of b, not "
           "the residuals by the components");
  }
  MatrixXd companion = MatrixXd::Zero(n, n);
  companion.diagonal(-1).setOnes();
  if (exercise::agree(MatrixXd(system.matrix.leftCols(n - 1)).reshaped().eval(),
                      MatrixXd(companion.leftCols(n - 1)).reshaped().eval(), 1e-12)) {
    reject(name,
           "the companion matrix is one in the basis b, e_1, ..., e_{n-1}, not in unit "
           "vectors");
  }
  const std::vector<double> history = solve(system.matrix, system.rhs, {0.0, n - 1}).history;
  expect({.what = name + ": the residuals",
          .got = as_vector(history),
          .expected = as_vector(residuals),
          .tolerance = 1e-9});
  std::vector<double> opposite = eigenvalues;
  for (double& value : opposite) value = -value;
  const double vanishing = characteristic_value(system.matrix, eigenvalues);
  if (vanishing > 1e-10 && characteristic_value(system.matrix, opposite) < 1e-10) {
    reject(name, "all eigenvalues have the other sign");
  }
  expect({.what = name + ": the product of all A - lambda_j, over its factors' norms",
          .got = vanishing,
          .expected = 0.0,
          .tolerance = 1e-10});
}

void check_misleading(double reported) {
  const std::string what = "reported residual " + exercise::text(reported);
  const Eigen::Vector2d diagonal = misleading(reported);
  if (diagonal.minCoeff() <= 0.0) reject(what, "M^-1 is not positive definite");
  const Eigen::Vector2d rhs = Eigen::Vector2d::Ones();
  const GmresResult result =
      solve(diagonal.asDiagonal().toDenseMatrix(), diagonal.cwiseProduct(rhs), {reported, 1});
  if (!result.converged) {
    reject(what, "GMRES does not stop after one iteration: it reports " +
                     exercise::text(result.history.back()));
  }
  const double true_residual = (rhs - result.solution).norm() / rhs.norm();
  if (true_residual < 0.5) {
    reject(what, "the solution is right: its residual is " + exercise::text(true_residual));
  }
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "condition number 1, and no progress",
        .formula = "A b, A^2 b, ... A^(n-1) b perpendicular to b, A^n b along b",
        .hint = "an orthogonal matrix may permute",
        .check =
            [] {
              for (const int n : {3, 8, 20}) check_stalling(n);
            }},
       {.title = "any history with any eigenvalues",
        .formula = "b_i^2 = r_(i-1)^2 - r_i^2; A b = e_1, A e_i = e_(i+1), A e_(n-1) by companion",
        .hint = "A B = B C with B = (b, e_1, ..., e_(n-1)) and the companion matrix C",
        .check =
            [] {
              check_history("eigenvalues 1, slow", {1.0, 1.0, 1.0, 1.0, 1.0},
                            {1.0, 0.99, 0.98, 0.97, 0.96});
              check_history("eigenvalues 1, 2, 3, 4, a late fall", {1.0, 2.0, 3.0, 4.0},
                            {1.0, 0.9, 0.8, 0.01});
              check_history("eigenvalues -3, 1e-2, 5, fast", {-3.0, 1e-2, 5.0}, {1.0, 0.1, 0.01});
            }},
       {.title = "a preconditioner that misleads",
        .formula = "|M^-1 (b - x)| <= reported |M^-1 b|, |b - x| >= |b|/2",
        .hint = "M^-1 is nearly blind to one direction",
        .check = [] {
          for (const double reported : {1e-3, 1e-10, 0.3, 0.9}) check_misleading(reported);
        }}});
}
