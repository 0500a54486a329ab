// Check of exercise 01.1: the reader's closed forms against discrete sums of f.
#include "chapters/check.hpp"

#include <numbers>

#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

double fourier_coefficient(double a, int k);
double folded_coefficient(double a, int k, int n);
double trapezoid_error(double a, int n);
int nodes_needed(double a, double tolerance);

namespace {

// f at n nodes.
Eigen::VectorXd samples(double a, int n) {
  Eigen::VectorXd f(n);
  for (int j = 0; j < n; ++j) f[j] = 1.0 / (1.0 - a * std::cos(2.0 * pi * j / n));
  return f;
}

Eigen::VectorXd discrete_coefficients(double a, int n) {
  return fourier_coefficients(samples(a, n).cast<Complex>()).real();
}

double rule(double a, int n) {
  return 2.0 * pi * samples(a, n).mean();
}

double integral(double a) {
  return 2.0 * pi / std::sqrt(1.0 - a * a);
}

std::string arguments(double a, const std::string& name, double value) {
  return "a = " + exercise::text(a) + ", " + name + " = " + exercise::text(value);
}

void check_coefficient(double a, int k) {
  // 512 nodes hold all modes of f: those beyond are below rounding.
  constexpr int n = 512;
  const double exact = discrete_coefficients(a, n)[(k + n) % n];
  const double first = discrete_coefficients(a, n)[1], mean = discrete_coefficients(a, n)[0];
  expect({.what = arguments(a, "k", k),
          .got = fourier_coefficient(a, k),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              // The first two agree for k < 0.
              {std::pow(first / mean, k) * mean,
               "this grows for negative wave numbers; f is even, so that c_{-k} = c_k"},
              {std::pow(mean / first, std::abs(k)) * mean,
               "this takes the root outside the unit circle: no Fourier coefficients of a smooth "
               "function grow"},
              {exact / mean, "the factor in front is missing, which the recurrence at k = 0 gives"},
              {2.0 * pi * exact, "the factor 1/(2 pi) of the definition is missing"}}});
}

void check_folding(double a, int n) {
  Eigen::VectorXd got(n), one_sided(n), unfolded(n), neighbours(n);
  const Eigen::VectorXd exact = discrete_coefficients(a, 512);
  const double folded = std::pow(exact[1] / exact[0], n);
  for (int k = 0; k < n; ++k) {
    got[k] = folded_coefficient(a, k, n);
    unfolded[k] = exact[k];
    one_sided[k] = exact[k] / (1.0 - folded);
    neighbours[k] = exact[k] + exact[n + k] + exact[n - k];
  }
  expect({.what = arguments(a, "N", n) + ", entries k = 0 ... N-1",
          .got = got,
          .expected = discrete_coefficients(a, n),
          .tolerance = 1e-12,
          .mistakes = {
              {one_sided,
               "only k, k + N, k + 2N, ... are added up here; k - N, k - 2N, ... look the "
               "same at the nodes"},
              {unfolded, "this is the coefficient of task 1: nothing is folded"},
              {neighbours, "only the nearest k + N and k - N are added: the series goes on"}}});
}

void check_error(double a, int n) {
  const double error = rule(a, n) - integral(a), h = 2.0 * pi / n;
  expect({.what = arguments(a, "N", n),
          .got = trapezoid_error(a, n),
          .expected = error,
          .tolerance = 1e-10,
          .mistakes = {{0.5 * error, "this is half of the error: the modes N and -N both count"},
                       {error / (2.0 * pi),
                        "this is the error of the mean: the length 2 pi of the "
                        "period is missing"},
                       {error / (4.0 * pi), "half of the modes and the length 2 pi are missing"},
                       {-error, "this is integral minus rule: the sign is the other one"},
                       {error / (1.0 + error / (2.0 * integral(a))),
                        "this is the first term of the series: 2N, 3N, ... fold onto 0 as well"},
                       {error + h / (1.0 - a),
                        "this rule has a node at 0 and at 2 pi, which are one and the same"}}});
}

void check_nodes(double a, double tolerance) {
  int n = 1;
  while (std::abs(rule(a, n) - integral(a)) > tolerance * integral(a)) ++n;
  const double exponent = std::log(tolerance / 2.0) / std::log(discrete_coefficients(a, 512)[1] /
                                                               discrete_coefficients(a, 512)[0]);
  const double got = nodes_needed(a, tolerance);
  expect({.what = arguments(a, "tolerance", tolerance),
          .got = got,
          .expected = static_cast<double>(n),
          .tolerance = 1e-12,
          .mistakes = {{std::ceil(0.5 * exponent), "this takes r^(2N) for the error: it is r^N"},
                       {std::ceil(2.0 * exponent), "this takes r^(N/2) for the error: it is r^N"},
                       {std::ceil(exponent * std::log(tolerance) / std::log(tolerance / 2.0)),
                        "the factor 2 of N and -N is missing"},
                       {n - 1.0, "rounded down: the error is still above the tolerance"},
                       {n + 1.0, "one node less would do"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the Fourier coefficients",
                         .formula = "-(a/2) c_{k-1} + c_k - (a/2) c_{k+1} = 1 for k = 0, else 0",
                         .hint = "the decaying solution is c_k = c_0 r^|k|; r solves a quadratic",
                         .check =
                             [] {
                               for (double a : {0.3, 0.8}) {
                                 for (int k : {0, 1, 4, -3}) check_coefficient(a, k);
                               }
                             }},
                        {.title = "what N nodes see of them",
                         .formula = "the sum of c_{k + mN} over all integers m",
                         .hint = "two geometric series, one for m >= 0 and one for m < 0",
                         .check =
                             [] {
                               for (int n : {1, 4, 7}) check_folding(0.8, n);
                             }},
                        {.title = "the error of the rule",
                         .formula = "2 pi times the sum of c_{mN} over all integers m but 0",
                         .hint = "task 2 at k = 0, without the term that is the integral",
                         .check =
                             [] {
                               for (double a : {0.3, 0.8, 0.95}) {
                                 for (int n : {1, 2, 5}) check_error(a, n);  // far above rounding
                               }
                             }},
                        {.title = "the nodes needed",
                         .formula = "2 r^N / (1 - r^N) <= tolerance",
                         .hint = "solve for r^N; the logarithm of r is negative",
                         .check = [] {
                           for (double a : {0.5, 0.9, 0.99}) {
                             for (double tolerance : {1e-2, 1e-5, 1e-9}) check_nodes(a, tolerance);
                           }
                         }}});
}
