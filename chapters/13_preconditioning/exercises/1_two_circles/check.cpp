// Check of exercise 13.1: eigenvalues of two circles against the book's matrix.
#include "chapters/check.hpp"

#include <array>

#include "closure/bordered_system.hpp"
#include "krylov/block_diagonal.hpp"
#include "support/spectra.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;

std::array<double, 4> pair_eigenvalues(double gap, int mode);
double least_eigenvalue(double gap);

namespace {

std::array<double, 4> exact_eigenvalues(double alpha, int mode) {
  const double turn = std::asinh(mode * std::sinh(2.0 * alpha));
  const double far = std::exp(-2.0 * mode * alpha + turn);
  const double near = std::exp(-2.0 * mode * alpha - turn);
  return {1.0 - far, 1.0 - near, 1.0 + near, 1.0 + far};
}

VectorXd vector_of(const std::array<double, 4>& values) {
  return Eigen::Map<const Eigen::Vector4d>(values.data());
}

// The reduced system of two unit circles, preconditioned by their own blocks.
MatrixXd pair_matrix(double gap, Index nodes) {
  const Curve circle = sample(Circle{1.0}, nodes, Side::fluid_outside);
  StokesProblem problem;
  for (const double side : {-1.0, 1.0}) {
    const Complex centre = side * (1.0 + 0.5 * gap);
    problem.components.push_back(
        {ComponentKind::free_body, place(circle, centre, 0.0), centre, {}, 0.0, {}});
  }
  const MatrixXd block = self_block({ComponentKind::free_body, circle, {}, {}, 0.0, {}});
  const MatrixXd inverse = invert_block(block);
  MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  for (const Index half : {0, 1}) {
    const auto columns = matrix.middleCols(2 * nodes * half, 2 * nodes);
    matrix.middleCols(2 * nodes * half, 2 * nodes) = (columns * inverse).eval();
  }
  return matrix;
}

void check_pair(double gap, int mode) {
  const std::string what = "g = " + exercise::text(gap) + ", n = " + std::to_string(mode);
  const auto exact = [&](double alpha, int n) { return vector_of(exact_eigenvalues(alpha, n)); };
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  const VectorXd got = vector_of(pair_eigenvalues(gap, mode)), expected = exact(alpha, mode);
  expect({.what = what,
          .got = got,
          .expected = expected,
          .tolerance = 1e-11,
          .mistakes = {{exact(std::acosh(1.0 + gap), mode),
                        "alpha is too large: half the distance of the centres is 1 + g/2"},
                       {exact(alpha, mode + 1), "this is the next mode"},
                       {exact(alpha, mode - 1), "this is the mode before"},
                       {expected.reverse().eval(), "ascending, please"},
                       {(expected.array() - 1.0).matrix().eval(),
                        "these are the eigenvalues of E; the operator is 1 + E"}}});
  MatrixXd matrix = pair_matrix(gap, 48);
  for (const double value : got) {
    matrix.diagonal().array() -= value;
    expect({.what = what + ": reciprocal condition number of A M^-1 less " + exercise::text(value),
            .got = 1.0 / test::condition_number(matrix),
            .expected = 0.0,
            .tolerance = 1e-11});
    matrix.diagonal().array() += value;
  }
}

void check_least(double gap) {
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  const double exact = exact_eigenvalues(alpha, 2)[0];
  expect({.what = "g = " + exercise::text(gap),
          .got = least_eigenvalue(gap),
          .expected = exact,
          .tolerance = 20.0 * gap,  // the next order
          .mistakes = {{8.0 * std::pow(gap, 3.0),
                        "this has the gap for alpha: alpha is the root of the gap"},
                       {-8.0 / 3.0 * std::pow(gap, 1.5), "asinh has a term of third order too"},
                       {exact_eigenvalues(alpha, 3)[0], "this is the mode 3: the least one is 2"},
                       {4.0 * std::sqrt(gap), "the terms of first order cancel"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the eigenvalues of two circles",
                         .formula = "1 +- exp(-2 n alpha +- asinh(n sinh 2 alpha))",
                         .hint = "cosh alpha is half the distance of the centres",
                         .check =
                             [] {
                               check_pair(1.0, 2);
                               check_pair(1.6, 3);
                             }},
                        {.title = "the least eigenvalue",
                         .formula = "1 - exp(-4 alpha + asinh(2 sinh 2 alpha)) for small alpha",
                         .hint = "expand to the third order in alpha",
                         .check = [] {
                           for (const double gap : {1e-2, 1e-3, 1e-4}) check_least(gap);
                         }}});
}
