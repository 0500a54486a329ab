// Check of exercise 05.3: steps against reflections, residuals and solutions against the book's GMRES.
#include "chapters/check.hpp"

#include <utility>

#include "closure/bordered_system.hpp"
#include "krylov/gmres.hpp"
#include "support/dense.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;

struct Step {
  VectorXd column;
  VectorXd next;
};

struct Rotation {
  double cosine, sine;
};

Step arnoldi_step(const LinearMap& apply, const MatrixXd& basis);
Rotation givens(double a, double b);
VectorXd residual_history(const MatrixXd& hessenberg, double beta);
VectorXd krylov_solution(const LinearMap& apply, const VectorXd& b, int k);

namespace {

[[noreturn]] void reject(const std::string& what, const std::string& mistake) {
  throw exercise::Rejection{exercise::line("for", what) + exercise::line("mistake", mistake)};
}

// A matrix without any symmetry.
MatrixXd generic_matrix(Index rows, Index columns) {
  MatrixXd matrix(rows, columns);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      const auto x = static_cast<double>(i), y = static_cast<double>(j);
      matrix(i, j) = std::sin(0.4 + 2.3 * x * x + 1.7 * y + 0.9 * x * y);
    }
  }
  return matrix;
}

LinearMap product(const MatrixXd& matrix) {
  return [&matrix](const VectorXd& v) -> VectorXd { return matrix * v; };
}

// The step by Householder's reflections, from the product w.
Step reflected(const MatrixXd& basis, const VectorXd& w) {
  const Index k = basis.cols();
  MatrixXd all(basis.rows(), k + 1);
  all << basis, w;
  const VectorXd last = test::orthogonal_factor(all).col(k);
  const double component = last.dot(w);
  VectorXd column(k + 1);
  column << basis.transpose() * w, std::abs(component);
  return {column, std::copysign(1.0, component) * last};
}

void check_step(Index k) {
  constexpr Index n = 9;
  const MatrixXd matrix = generic_matrix(n, n);
  const MatrixXd basis = test::orthogonal_factor(generic_matrix(n, n + 1).rightCols(k));
  const Step got = arnoldi_step(product(matrix), basis);
  const Step exact = reflected(basis, matrix * basis.col(k - 1));
  const Step of_first = reflected(basis, matrix * basis.col(0));
  const double length = exact.column[k];
  const VectorXd second = length * VectorXd::Unit(k + 1, k);
  const std::string what = "9 unknowns, " + std::to_string(k) + " basis vectors: ";
  const std::string first = "this step multiplies the first basis vector by A, not the last one";
  const std::string unscaled = "the next vector has the length 1: divide by h_{k+1,k}";
  expect({.what = what + "the entries of H",
          .got = got.column,
          .expected = exact.column,
          .tolerance = 1e-11,
          .mistakes = {{of_first.column, first},
                       {second, "the second pass gives corrections: add them to the entries"},
                       {exact.column.head(k).eval(), "the last entry is missing: the length of w'"},
                       {length * exact.column, unscaled}}});
  expect({.what = what + "v_{k+1}",
          .got = got.next,
          .expected = exact.next,
          .tolerance = 1e-11,
          .mistakes = {{of_first.next, first},
                       {(length * exact.next).eval(), unscaled},
                       {(matrix * basis.col(k - 1)).normalized().eval(),
                        "the components along the basis are not subtracted"}}});
}

// Where A is nearly a multiple of the identity, almost nothing is left of A v_k.
void check_cancellation() {
  constexpr Index n = 30, k = 5;
  const MatrixXd matrix = -0.5 * MatrixXd::Identity(n, n) + 1e-9 * generic_matrix(n, n);
  const MatrixXd basis = test::orthogonal_factor(generic_matrix(n, k));
  const Step got = arnoldi_step(product(matrix), basis);
  if (got.next.size() != n) return;  // has been reported
  const double overlap = (basis.transpose() * got.next).cwiseAbs().maxCoeff();
  if (overlap < 1e-12) return;
  reject("A = -1/2 and a matrix of the size 1e-9",
         "a scalar product of v_{k+1} with the basis is " + exercise::text(overlap) +
             ": subtract a second time");
}

void check_rotation(double a, double b) {
  const double rho = std::sqrt(a * a + b * b);
  const auto [cosine, sine] = givens(a, b);
  const Eigen::Vector2d got{cosine, sine}, exact{a / rho, b / rho};
  const Eigen::Vector2d back{a / rho, -b / rho}, exchanged{b / rho, a / rho};
  expect({.what = "cosine and sine for a = " + exercise::text(a) + ", b = " + exercise::text(b),
          .got = got,
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{back, "this rotation turns the other way: it does not remove b"},
                       {(-exact).eval(), "rho is negative where a is: keep the sign of a"},
                       {exchanged, "cosine and sine are exchanged"},
                       {(rho * exact).eval(), "divide by rho"}}});
}

void check_vanishing(double b) {
  const auto [cosine, sine] = givens(0.0, b);
  if (!std::isfinite(cosine) || !std::isfinite(sine)) {
    reject("cosine and sine for a = 0, b = " + exercise::text(b),
           "a may be zero: do not divide by it");
  }
  check_rotation(0.0, b);
}

// Two slender ellipses in a shear flow.
DenseSystem two_ellipses() {
  constexpr Index nodes = 24;
  StokesProblem problem;
  problem.background.resize(2 * nodes);
  for (const Index k : {0, 1}) {
    const Complex centre = k == 0 ? Complex{0.0} : Complex{1.3, 0.4};
    const double angle = k == 0 ? 1.1 : 1.6;
    const Curve curve = place(sample(Ellipse{1.0, 0.4}, nodes, Side::fluid_outside), centre, angle);
    problem.components.push_back({ComponentKind::free_body, curve, centre, {}, 0.0, {}});
    problem.background.segment(k * nodes, nodes) = curve.x.imag().cast<Complex>();
  }
  return assemble(problem, ClosureForm::reduced);
}

// A small system whose residuals fall slowly.
DenseSystem small_system() {
  constexpr Index n = 12;
  return {1.5 * MatrixXd::Identity(n, n) + generic_matrix(n, n), generic_matrix(n, 1)};
}

// V_k and H_k of (05.3), by reflections.
std::pair<MatrixXd, MatrixXd> basis_and_hessenberg(const DenseSystem& system, Index k) {
  MatrixXd basis = system.rhs.normalized(), hessenberg = MatrixXd::Zero(k + 1, k);
  for (Index j = 0; j < k; ++j) {
    const Step step = reflected(basis, system.matrix * basis.col(j));
    hessenberg.col(j).head(j + 2) = step.column;
    basis.conservativeResize(Eigen::NoChange, j + 2);
    basis.col(j + 1) = step.next;
  }
  return {basis.leftCols(k), hessenberg};
}

// The residual of Galerkin's condition after each iteration: the last row of H_k y.
VectorXd galerkin_residuals(const MatrixXd& hessenberg, double beta) {
  VectorXd residuals(hessenberg.rows());
  residuals[0] = beta;
  for (Index k = 1; k < hessenberg.rows(); ++k) {
    const VectorXd y = test::solve(hessenberg.topLeftCorner(k, k), beta * VectorXd::Unit(k, 0));
    residuals[k] = std::abs(hessenberg(k, k - 1) * y[k - 1]);
  }
  return residuals;
}

void check_history(const std::string& name, const DenseSystem& system, int iterations) {
  const double beta = system.rhs.norm();
  const MatrixXd hessenberg = basis_and_hessenberg(system, iterations).second;
  const std::vector<double> history =
      gmres(product(system.matrix), {}, system.rhs, {0.0, iterations}).history;
  const VectorXd exact = beta * VectorXd::Map(history.data(), std::ssize(history));
  VectorXd raw(exact.size()), opposite = exact;
  raw[0] = beta;
  for (Index j = 0; j < iterations; ++j) {
    const double sine = hessenberg(j + 1, j) / std::hypot(hessenberg(j, j), hessenberg(j + 1, j));
    raw[j + 1] = raw[j] * sine;
  }
  for (Index j = 1; j < opposite.size(); j += 2) opposite[j] = -opposite[j];
  expect({.what = name + ", " + std::to_string(iterations) + " iterations",
          .got = residual_history(hessenberg, beta),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {
              {raw, "the earlier rotations act on the new column, too"},
              {galerkin_residuals(hessenberg, beta),
               "these are the residuals of Galerkin's condition: they have the tangent"},
              {(exact / beta).eval(), "these residuals are relative to beta"},
              {opposite, "a residual is a length: take the modulus"},
              {exact.tail(iterations).eval(), "the first entry is the residual before: beta"}}});
}

void check_solution(const std::string& name, const DenseSystem& system, int iterations) {
  const LinearMap apply = product(system.matrix);
  const auto [basis, hessenberg] = basis_and_hessenberg(system, iterations);
  const double beta = system.rhs.norm();
  const auto after = [&](int k) { return gmres(apply, {}, system.rhs, {0.0, k}).solution; };
  const VectorXd exact = after(iterations);
  const VectorXd first = beta * VectorXd::Unit(iterations, 0);
  // R with a positive diagonal.
  const MatrixXd q = test::orthogonal_factor(hessenberg);
  MatrixXd triangular = q.transpose() * hessenberg;
  for (Index i = 0; i < iterations; ++i) {
    if (triangular(i, i) < 0.0) triangular.row(i) *= -1.0;
  }
  expect({.what = name + ", " + std::to_string(iterations) + " iterations",
          .got = krylov_solution(apply, system.rhs, iterations),
          .expected = exact,
          .tolerance = 1e-9,
          .mistakes = {
              {(basis * test::solve(hessenberg.topRows(iterations), first)).eval(),
               "this is the solution by Galerkin's condition: it satisfies the first k rows of H"},
              {(basis * test::solve(triangular, first)).eval(),
               "the rotations act on the right-hand side, too"},
              {(exact / beta).eval(), "the right-hand side has the length beta"},
              {after(iterations - 1), "this is an iteration too few"},
              {after(iterations + 1), "this is an iteration too many"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "a step of Arnoldi's method",
        .formula = "w = A v_k, h_ik = v_i . w, w' = w - sum h_ik v_i (twice), h_{k+1,k} = |w'|",
        .hint = "the second pass is the first one again; its scalar products are added",
        .check =
            [] {
              for (const Index k : {2, 3, 6}) check_step(k);
              check_cancellation();
            }},
       {.title = "the rotation",
        .formula = "cos = a/rho, sin = b/rho, rho^2 = a^2 + b^2",
        .hint = "std::hypot",
        .check =
            [] {
              check_rotation(3.0, 4.0);
              check_rotation(-1.2, 0.5);
              check_rotation(-0.3, -0.8);
              check_rotation(1e-3, 2.0);
              check_vanishing(2.0);
            }},
       {.title = "the residuals before the solution",
        .builds_on = {2},
        .formula = "|gamma_{k+1}| = |sin phi_k| |gamma_k|",
        .hint = "a rotation acts on two rows of all columns, also on the right-hand side",
        .check =
            [] {
              check_history("12 unknowns", small_system(), 7);
              check_history("two ellipses", two_ellipses(), 9);
            }},
       {.title = "the solution",
        .builds_on = {1, 2},
        .formula = "R y = g, x = V_k y, from the rotated matrix (R, g; 0, gamma_{k+1})",
        .hint = "the first k rows, from the last one upwards",
        .check = [] {
          for (const int k : {2, 5, 9}) check_solution("12 unknowns", small_system(), k);
          for (const int k : {4, 12}) check_solution("two ellipses", two_ellipses(), k);
        }}});
}
