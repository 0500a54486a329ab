// Check of exercise 05.1: counts from polynomials against GMRES and Chebyshev's recurrence.
#include "chapters/check.hpp"

#include <utility>

#include "krylov/gmres.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::VectorXd;
using exercise::expect;

double residual_on_circle(double centre, double radius, int k);
int iterations_on_interval(double kappa, double tolerance);

namespace {

// centre + radius S with the cyclic shift S, whose eigenvalues are the roots of unity.
double residual_of_gmres(double centre, double radius, int k) {
  constexpr Index order = 40;
  const LinearMap apply = [&](const VectorXd& v) -> VectorXd {
    VectorXd shifted(order);
    shifted << v.tail(1), v.head(order - 1);
    return centre * v + radius * shifted;
  };
  return gmres(apply, {}, VectorXd::Unit(order, 0), {0.0, k}).history.back();
}

void check_circle(double centre, double radius, int k) {
  const double exact = residual_of_gmres(centre, radius, k);
  expect({.what = "c = " + exercise::text(centre) + ", r = " + exercise::text(radius) +
                  ", k = " + std::to_string(k),
          .got = residual_on_circle(centre, radius, k),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{std::pow(radius / centre, k),
                        "this is the bound (r/c)^k: the mean square can be less"},
                       {residual_of_gmres(1.0, radius, k), "this is the circle about 1"},
                       {exact * exact, "a root is missing: a norm is asked for"},
                       {residual_of_gmres(centre, radius, k - 1),
                        "a polynomial of degree k has k + 1 coefficients"}}});
}

void check_interval(double kappa, double tolerance) {
  const double at_zero = (kappa + 1.0) / (kappa - 1.0);
  double before = 1.0, now = at_zero;
  int needed = 1;
  for (; now < 1.0 / tolerance; ++needed) {
    before = std::exchange(now, 2.0 * at_zero * now - before);
  }
  const double by_condition = std::acosh(1.0 / tolerance) / std::log(at_zero);
  const double one_sided = std::log(1.0 / tolerance) / std::acosh(at_zero);
  const double got = iterations_on_interval(kappa, tolerance);
  expect({.what = "kappa = " + exercise::text(kappa) + ", tolerance " + exercise::text(tolerance),
          .got = got,
          .expected = static_cast<double>(needed),
          .tolerance = 1e-12,
          .mistakes = {
              {std::ceil(by_condition),
               "this is the rate of the condition number: it is that of its root"},
              {std::ceil(one_sided), "the factor 2 is missing: 1/cosh(k t) is nearly 2 exp(-k t)"},
              {needed - 1.0, "here the bound is still above the tolerance"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the residual on a circle",
        .formula = "the least sum of |a_j|^2 with sum of a_j (-c/r)^j = 1, j = 0 ... k",
        .hint = "Cauchy and Schwarz",
        .check =
            [] {
              for (const int k : {1, 4, 9}) {
                check_circle(1.0, 0.5, k);
                check_circle(2.0, 1.2, k);
              }
            }},
       {.title = "the count on an interval",
        .formula = "1/cosh(k t) <= tolerance, cosh t = (kappa + 1)/(kappa - 1)",
        .hint = "the standard library has acosh",
        .check = [] {
          for (const double kappa : {4.0, 25.0, 1000.0}) {
            for (const double tolerance : {1e-2, 1e-8}) check_interval(kappa, tolerance);
          }
        }}});
}
