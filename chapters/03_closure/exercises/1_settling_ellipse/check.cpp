// Check of exercise 03.1: closed forms against sums over nodes and against the solver.
#include "chapters/check.hpp"

#include <numbers>

#include "double_layer/kernels.hpp"
#include "support/problems.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

double exact_velocity(const Ellipse& ellipse, double gauge);
double mean_of_stokeslet(const Curve& curve, double gauge);
double discrete_velocity(const Ellipse& ellipse, double gauge, int n);
int nodes_needed(const Ellipse& ellipse, double tolerance);

namespace {

constexpr double viscosity = 0.25 / pi;  // 4 pi mu = 1

std::string arguments(const Ellipse& e, const std::string& name, double value) {
  return "a = " + exercise::text(e.a) + ", b = " + exercise::text(e.b) + ", " + name + " = " +
         exercise::text(value);
}

// Mean over n nodes of the Stokeslet of a unit force along a direction, along that direction.
double mean(const Ellipse& ellipse, double gauge, int n, Complex force = 1.0) {
  const Curve curve = sample(ellipse, n, Side::fluid_outside);
  double sum = 0.0;
  for (const Complex r : curve.x) sum += dot(force, stokeslet(r, force, viscosity, gauge));
  return sum / n;
}

// What the solver of the book finds.
double solved(const Ellipse& ellipse, double gauge, int n) {
  const Curve curve = sample(ellipse, n, Side::fluid_outside);
  const StokesProblem problem{
      {{ComponentKind::free_body, curve, 0.0, 1.0, 0.0, {}}}, viscosity, {}, gauge};
  return test::solve_dense(problem, ClosureForm::reduced).motions[0].velocity.real();
}

void check_exact(const Ellipse& e, double gauge) {
  constexpr int n = 400;  // no alias is above rounding
  const double exact = mean(e, gauge, n);
  expect({.what = arguments(e, "l", gauge),
          .got = exact_velocity(e, gauge),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{mean(e, gauge, n, imaginary), "this is the velocity across the ellipse"},
                       {0.5 - std::log(e.a / gauge), "this is a circle of radius a"},
                       {exact - std::log(gauge), "the gauge length is missing"},
                       {exact / (4.0 * pi), "the unit is F / (4 pi mu)"},
                       {-exact, "the sign is the other one: F pushes the body along"}}});
}

void check_mean(int n) {
  const Ellipse e{2.0, 0.8};
  const Curve curve = sample(e, n, Side::fluid_outside);
  const Eigen::VectorXd w = weights(curve);
  double over_arclength = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    over_arclength += w[j] / w.sum() * stokeslet(curve.x[j], 1.0, viscosity, 3.0).real();
  }
  const double exact = mean(e, 3.0, n);
  expect({.what = arguments(e, "l", 3.0) + ", N = " + std::to_string(n),
          .got = mean_of_stokeslet(curve, 3.0),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {
              {over_arclength,
               "this is the mean over the arclength; the traction weighs with dt, not ds"},
              {exact * n, "a mean is divided by the number of nodes"},
              {exact / (4.0 * pi), "this takes the viscosity 1: the unit is F / (4 pi mu)"}}});
}

void check_discrete(const Ellipse& e, int n) {
  const double m = (e.a - e.b) / (e.a + e.b), folded = std::pow(-m, n / 2);
  const double exact = mean(e, 3.0, n), limit = mean(e, 3.0, 400);
  expect(
      {.what = arguments(e, "l", 3.0) + ", N = " + std::to_string(n),
       .got = discrete_velocity(e, 3.0, n),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {
           {limit + 2.0 / n * folded - 0.5 * (1.0 - m * m) / m * folded,
            "this is the first alias only: 2N, 3N, ... fold onto 0 as well"},
           {exact + 2.0 / n * std::log(1.0 - folded), "the aliases of the logarithm are missing"},
           {limit - 2.0 / n * std::log(1.0 - folded), "the logarithm alone has aliases here"},
           {2.0 * limit - exact, "exact minus discrete: the sign is the other one"},
           {limit, "this is the exact velocity"}}});
}

// The solver differs from the mean by what aliases in the double layer's kernel, about N m^N.
void check_against_solver(int n) {
  const Ellipse e{2.0, 1.0};
  expect({.what = arguments(e, "l", 3.0) + ", N = " + std::to_string(n) + ", against the solver",
          .got = discrete_velocity(e, 3.0, n),
          .expected = solved(e, 3.0, n),
          .tolerance = n * std::pow(1.0 / 3.0, n)});
}

void check_nodes(const Ellipse& e, double tolerance) {
  const double limit = mean(e, 1.0, 400);
  int n = 4;
  while (std::abs(mean(e, 1.0, n) - limit) > tolerance) n += 2;
  const double m = (e.a - e.b) / (e.a + e.b);
  const double got = nodes_needed(e, tolerance);
  expect({.what = arguments(e, "tolerance", tolerance),
          .got = got,
          .expected = static_cast<double>(n),
          .tolerance = 1e-12,
          .mistakes = {{2.0 * std::ceil(0.5 * std::log(tolerance) / std::log(m)),
                        "this takes m^N for the error: it is m^(N/2)"},
                       {n + 2.0, "two nodes less would do"},
                       {n - 2.0, "here the error is still above the tolerance"},
                       {0.5 * n, "half of it: this counts the roots of unity, not the nodes"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the exact velocity",
        .formula = "the mean over t of -log(|z|/l) + (1 + Re(z/conj(z)))/2",
        .hint = "z = R (w + m/w); both terms are power series in m",
        .check =
            [] {
              check_exact({2.0, 1.0}, 1.0);
              check_exact({1.5, 1.2}, 7.0);
            }},
       {.title = "the mean over the nodes",
        .formula = "1/N sum_j e.S(x_j) e, e along direction 1",
        .hint = "every node has the same weight",
        .check =
            [] {
              for (int n : {6, 10}) check_mean(n);
            }},
       {.title = "the velocity with N nodes",
        .builds_on = {1},
        .formula = "the powers 0, M, 2M, ... of q = w^2, M = N/2",
        .hint = "the product of 1 + m q over the roots of unity of order M is 1 - (-m)^M",
        .check =
            [] {
              for (int n : {6, 8, 14}) check_discrete({2.0, 0.8}, n);
              for (int n : {18, 24}) check_against_solver(n);
            }},
       {.title = "the nodes needed",
        .builds_on = {1, 3},
        .formula = "|discrete - exact| <= tolerance",
        .hint = "count up from 4 in steps of 2",
        .check = [] {
          for (double tolerance : {1e-3, 1e-6, 1e-10}) {
            check_nodes({2.0, 1.0}, tolerance);
            check_nodes({4.0, 1.0}, tolerance);
          }
        }}});
}
