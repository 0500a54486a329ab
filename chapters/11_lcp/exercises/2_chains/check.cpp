// Check of exercise 11.2: triangular solves, eigenvalues, and the library's pivots.
#include "chapters/check.hpp"

#include <fstream>

#include "lcp/lemke.hpp"
#include "study/plot.hpp"
#include "support/spectra.hpp"

using namespace stokesbook;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;

VectorXd sweep(const MatrixXd& matrix, const VectorXd& q, const VectorXd& z);
double left_by_sweep(int m);
double sweeps_needed(int m, double part);

namespace {

MatrixXd chain(int m) {
  MatrixXd matrix = 2.0 * MatrixXd::Identity(m, m);
  matrix.diagonal(1).setConstant(-1.0);
  matrix.diagonal(-1).setConstant(-1.0);
  return matrix;
}

// Pushed together at both ends: all forces are one.
VectorXd push(int m) {
  return -chain(m) * VectorXd::Ones(m);
}

MatrixXd upper(const MatrixXd& matrix) {
  return matrix.triangularView<Eigen::StrictlyUpper>();
}

// (D + L) z' = -q - U z, where no force is dropped.
VectorXd by_substitution(const MatrixXd& matrix, const VectorXd& q, const VectorXd& z) {
  return matrix.triangularView<Eigen::Lower>().solve(-q - upper(matrix) * z);
}

VectorXd by_jacobi(const MatrixXd& matrix, const VectorXd& q, const VectorXd& z) {
  return (z - (q + matrix * z).cwiseQuotient(matrix.diagonal())).cwiseMax(0.0);
}

void check_sweep() {
  for (const int m : {3, 7}) {
    const VectorXd z = VectorXd::LinSpaced(m, 0.5, 2.0), q = push(m);
    expect({.what = "a chain of " + std::to_string(m) + ", all contacts push",
            .got = sweep(chain(m), q, z),
            .expected = by_substitution(chain(m), q, z),
            .tolerance = 1e-13,
            .mistakes = {{by_jacobi(chain(m), q, z), "this takes the forces before the sweep"}}});
  }
  // The first of two contacts is open: it gets no force, and the second is not pulled by it.
  const VectorXd q = Eigen::Vector2d(1.0, -1.0), z = VectorXd::Zero(2);
  expect({.what = "two contacts, the first one open",
          .got = sweep(chain(2), q, z),
          .expected = VectorXd(Eigen::Vector2d(0.0, 0.5)),
          .tolerance = 1e-13,
          .mistakes = {{by_substitution(chain(2), q, z), "forces may not be negative"}}});
}

// The largest eigenvalue of -(D + L)^{-1} U.
double largest_eigenvalue(int m) {
  const MatrixXd matrix = chain(m);
  const MatrixXd iteration = matrix.triangularView<Eigen::Lower>().solve(upper(matrix));
  return test::eigenvalues(iteration).cwiseAbs().maxCoeff();
}

void check_left() {
  for (const int m : {2, 5, 20}) {
    const double exact = largest_eigenvalue(m);
    expect({.what = "m = " + std::to_string(m),
            .got = left_by_sweep(m),
            .expected = exact,
            .tolerance = 1e-8,
            .mistakes = {{std::sqrt(exact), "this is the part that Jacobi's sweep leaves"},
                         {1.0 - exact, "this is the part that is taken away"},
                         {largest_eigenvalue(m - 1), "the mode vanishes at 0 and at m + 1"}}});
  }
}

void check_needed() {
  for (const int m : {5, 20}) {
    const double exact = std::log(1e-6) / std::log(largest_eigenvalue(m));
    expect({.what = "m = " + std::to_string(m) + ", to a millionth",
            .got = sweeps_needed(m, 1e-6),
            .expected = exact,
            .tolerance = 1e-6 * exact,
            .mistakes = {{exact / std::log(10.0), "the logarithms must have one base"},
                         {-exact, "the number is positive where the part is below one"}}});
  }
}

int sweeps(int m) {
  VectorXd z = VectorXd::Zero(m);
  int count = 0;
  while ((z - VectorXd::Ones(m)).lpNorm<Eigen::Infinity>() > 1e-6 && count < 100000) {
    z = sweep(chain(m), push(m), z);
    ++count;
  }
  return count;
}

void check_experiment() {
  study::Plot plot{
      .title = "A chain of contacts",
      .x_label = "contacts m",
      .y_label = "sweeps, pivots",
      .lines = {{.label = "sweeps"}, {.label = "sweeps predicted"}, {.label = "pivots"}}};
  std::ofstream table("chains.csv");
  table << "contacts,sweeps,predicted,pivots\n";
  for (int m = 4; m <= 64; m *= 2) {
    const int counted = sweeps(m), pivots = lemke({chain(m), push(m)}).iterations;
    const double predicted = sweeps_needed(m, 1e-6);
    const double numbers[] = {static_cast<double>(counted), predicted, static_cast<double>(pivots)};
    for (std::size_t line = 0; line < 3; ++line) {
      plot.lines[line].points.push_back({static_cast<double>(m), numbers[line]});
    }
    table << m << ',' << counted << ',' << predicted << ',' << pivots << '\n';
    expect({.what = "predicted sweeps of " + std::to_string(m) + " contacts over those counted",
            .got = predicted / counted,
            .expected = 1.0,
            .tolerance = 0.15,
            .mistakes = {{2.0, "Jacobi takes twice as many"}}});
  }
  std::ofstream("chains.svg") << draw_plot(plot) << '\n';
}

}  // namespace

int main() {
  return exercise::run({{.title = "a sweep",
                         .formula = "z_i = max(0, z_i - w_i / M_ii), one i after another",
                         .hint = "w_i needs the forces that this sweep has changed already",
                         .check = check_sweep},
                        {.title = "what is left",
                         .formula = "cos^2(pi / (m + 1))",
                         .hint = "2 c^2 s_i = ... with s_i = sin(i t), by the sum of two sines",
                         .check = check_left},
                        {.title = "the sweeps",
                         .builds_on = {2},
                         .formula = "log(part) / log(left)",
                         .hint = "after k sweeps the error is left^k of what it was",
                         .check = check_needed},
                        {.title = "the experiment",
                         .builds_on = {1, 3},
                         .formula = "the sweeps counted in task 4 are those predicted",
                         .hint = "it uses sweep() and sweeps_needed()",
                         .check = check_experiment}});
}
