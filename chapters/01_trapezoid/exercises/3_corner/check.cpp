// Check of exercise 01.3: rules and integrals that are known in closed form.
#include "chapters/check.hpp"

#include <numbers>

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

using Function = std::function<double(double)>;

double trapezoid(const Function& f, int n);
double end_error(double slope_start, double slope_end, int n);
double corner_error(double jump, double theta, int n);
double repaired(const Function& f, int n);
double repaired_error(double slope_start, double slope_end, int n);

namespace {

const double last = 2.0 * pi;

std::string nodes(int n) {
  return "N = " + std::to_string(n);
}

// e^t: the sum over the nodes is a geometric series.
void check_rule(int n) {
  const double h = last / n, inner = (std::exp(last) - 1.0) / std::expm1(h) - 1.0;
  const double exact = h * (inner + 0.5 * (1.0 + std::exp(last)));
  expect({.what = "f(t) = exp(t), " + nodes(n),
          .got = trapezoid([](double t) { return std::exp(t); }, n),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {
              {exact + 0.5 * h * (1.0 + std::exp(last)),
               "both ends count in full here, but each belongs to one interval only"},
              {h * (inner + 1.0),
               "this leaves out the end 2 pi, which is the start only for a periodic function"},
              {h * (inner + std::exp(last)), "this leaves out the end 0"},
              {h * inner, "this leaves out both ends"},
              {exact / h, "the weight h is missing"},
              {std::expm1(last), "this is the integral itself, not the rule"}}});
}

// t^2: a parabola has no higher derivatives, so that the leading term is the whole error. Its rule
// is h^3 (1^2 + ... + N^2) less half of the last term.
void check_end_error(int n) {
  const double h = last / n;
  const double squares = n * (n + 1.0) * (2.0 * n + 1.0) / 6.0 - 0.5 * n * n;
  const double exact = h * h * h * squares - last * last * last / 3.0;
  expect({.what = "f(t) = t^2, slopes 0 and 4 pi, " + nodes(n),
          .got = end_error(0.0, 2.0 * last, n),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{-0.5 * exact, "this is the error of the midpoint rule"},
                       {-exact, "this is integral minus rule: the sign is the other one"},
                       {0.5 * exact, "half of it: B_2/2! is 1/12, not 1/24"},
                       {exact / (last * last), "h is 2 pi / N, not 1 / N"}}});
}

// |sin((t - s)/2)| has one corner, at s, with the jump 1 and the integral 4; its rule is a sum of
// sines, h cos((theta - 1/2) h/2) / sin(h/4).
void check_corner(double theta, int n) {
  const double h = last / n;
  const double exact = h * std::cos(0.5 * (theta - 0.5) * h) / std::sin(0.25 * h) - 4.0;
  // The tolerance is of the size h^2 of the next term, in units of the error of a corner on a node:
  // the error itself may vanish.
  const double scale = 12.0 / (h * h);
  expect(
      {.what = "J = 1, theta = " + exercise::text(theta) + ", " + nodes(n) + ", in units of h^2/12",
       .got = scale * corner_error(1.0, theta, n),
       .expected = scale * exact,
       .tolerance = h * h,
       .mistakes = {{-1.0, "this holds only where the corner is a node"},
                    {-scale * exact, "this is integral minus rule: the sign is the other one"},
                    {2.0 * scale * exact, "twice the error"},
                    {0.5 * scale * exact, "half of the error"}}});
}

// Integrals of t^2 and e^t; the error is of the order h^6.
void check_repaired(const std::string& name, const Function& f, double integral) {
  constexpr int n = 64;
  const auto in_s = [&f](bool first_half) {
    double sum = 0.0;
    for (int j = 1; j < n; ++j) {
      const double s = last * j / n;
      sum += first_half ? f(s - std::sin(s)) : f(s) * (1.0 - std::cos(s));
    }
    return last / n * sum;
  };
  expect({.what = "f(t) = " + name + ", " + nodes(n),
          .got = repaired(f, n),
          .expected = integral,
          .tolerance = 1e-8,
          .mistakes = {
              {in_s(true) + 0.5 * last / n * (f(0.0) + f(last)), "the derivative dt/ds is missing"},
              {in_s(false), "f is taken at s, not at t(s)"}}});
}

void check_repaired_error(int n) {
  // t^2, whose slopes are 0 and 4 pi. Measured by the same rule, written out: the ends contribute
  // nothing. The next term is smaller by a factor of the order h^2.
  const double h = last / n;
  double rule = 0.0;
  for (int j = 1; j < n; ++j) {
    rule += h * std::pow(j * h - std::sin(j * h), 2) * (1.0 - std::cos(j * h));
  }
  const double exact = rule - last * last * last / 3.0;
  expect({.what = "f(t) = t^2, slopes 0 and 4 pi, " + nodes(n),
          .got = repaired_error(0.0, 2.0 * last, n),
          .expected = exact,
          .tolerance = h * h,
          .mistakes = {{-std::pow(h, 4) / 720.0 * 2.0 * last,
                        "this has the order 4: the third derivatives at the ends do vanish"},
                       {-exact, "this is integral minus rule: the sign is the other one"},
                       {0.1 * exact, "the fifth derivative of s^5/12 is 10, not 1"},
                       {exact / 120.0, "the fifth derivative of s^5/12 has the factor 5!"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the rule for open ends",
        .formula = "h (f(0)/2 + f(h) + f(2h) + ... + f(2 pi - h) + f(2 pi)/2)",
        .hint = "each interval contributes half of its two ends",
        .check =
            [] {
              for (int n : {1, 2, 9}) check_rule(n);
            }},
       {.title = "the error of open ends",
        .formula = "B_2 h^2/2! (f'(2 pi) - f'(0)), B_2 = 1/6",
        .hint = "try it on a parabola, for which it is exact",
        .check =
            [] {
              for (int n : {1, 3, 10}) check_end_error(n);
            }},
       {.title = "the error of a corner",
        .formula = "-J h^2/2 B_2(theta), with the Bernoulli polynomial theta^2 - theta + 1/6",
        .hint = "compare rule and integral of J max(0, t - theta h) on the one cell [0, h]",
        .check =
            [] {
              for (double theta : {0.0, 0.3, 0.5, 0.9}) check_corner(theta, 100);
            }},
       {.title = "the repaired rule",
        .builds_on = {1},
        .formula = "the rule in s for f(s - sin s) (1 - cos s)",
        .hint = "dt = (1 - cos s) ds",
        .check =
            [] {
              check_repaired(
                  "t^2", [](double t) { return t * t; }, last * last * last / 3.0);
              check_repaired(
                  "exp(t)", [](double t) { return std::exp(t); }, std::expm1(last));
            }},
       {.title = "the error of the repaired rule",
        .formula = "B_6 h^6/6! (F^(5)(2 pi) - F^(5)(0)), B_6 = 1/42, F the integrand in s",
        .hint = "near its ends F is f'(0) s^5/12 + an even function",
        .check = [] {
          for (int n : {64, 100}) check_repaired_error(n);
        }}});
}
