// Check of exercise 09.4: closed solutions, and what the formulas have to be exact for.
#include "chapters/check.hpp"

using namespace stokesbook;
using Eigen::VectorXd;
using exercise::expect;
using exercise::text;

double euler_error(double h, double rate, double derivative_of_rate);
double second_weight(double c);
double length_allowed(double h, double error, int m);
double more_steps(int order, double digits);
VectorXd guess_weights(int count);

namespace {

// A step from q of the rate q^2, whose solution is q/(1 - t q).
void check_error(double q, double h) {
  const double rate = q * q, slope = 2.0 * q;
  const double exact = -h * h * q * q * q / (1.0 - h * q);
  expect({.what = "h = " + text(h) + ", f = " + text(rate) + ", f' = " + text(slope),
          .got = euler_error(h, rate, slope),
          .expected = exact,
          .tolerance = 2.0 * std::abs(h * q),  // the next order
          .mistakes = {
              {-exact, "this is exact minus Euler: the sign is the other one"},
              {2.0 * exact, "Taylor's formula has a half here"},
              {-2.0 * exact, "this is exact minus Euler, without the half of Taylor's formula"},
              {exact / rate, "the second derivative of q is f' f: the chain rule gives a factor f"},
              {exact / slope, "the second derivative of q is f' f: the factor f' is missing"}}});
}

// The rate t is integrated exactly by a method of order two: b_2 c h^2 = h^2/2.
void check_weight(double c) {
  constexpr double h = 0.5, integral = 0.5 * h * h;
  const double exact = integral / (h * (c * h));
  expect({.what = "c = " + text(c),
          .got = second_weight(c),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {{0.5, "this is the weight for c = 1, Heun's method"},
                       {0.5 * c, "b_2 c = 1/2: divide by c"},
                       {1.0 / c, "b_2 c is 1/2, not 1"},
                       {1.0 - exact, "this is the weight of the first stage"}}});
}

void check_length(double factor, double h, int m) {
  const double error = factor * std::pow(h, m), exact = std::pow(factor, -1.0 / m);
  const double ratio = exact / h;
  expect({.what = "h = " + text(h) + ", e = " + text(error) + ", m = " + std::to_string(m),
          .got = length_allowed(h, error, m),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{h / ratio, "an error above 1 makes the step shorter, not longer"},
                       {h / error, "this is as if errors fell in proportion to h: take the root"},
                       {h * std::pow(error, -1.0 / (m + 1)),
                        "this takes m + 1 for m: here m is the power of the error of a step"},
                       {ratio, "this is the factor: the task asks for the length"}}});
}

// Errors n^-p of runs with n steps.
void check_steps(int p, double digits) {
  double low = 1.0, high = 1e12;
  for (int bisection = 0; bisection < 200; ++bisection) {
    const double middle = std::sqrt(low * high);
    (std::pow(middle, -p) > std::pow(10.0, -digits) ? low : high) = middle;
  }
  expect(
      {.what = "p = " + std::to_string(p) + ", " + text(digits) + " digits",
       .got = more_steps(p, digits),
       .expected = low,
       .tolerance = 1e-10,
       .mistakes = {
           {std::pow(10.0, digits / (p + 1)),
            "this has the order of the error of one step, p + 1; over a run one power is lost"},
           {std::pow(10.0, digits), "this is as if the order were one: take the root of order p"},
           {digits / p, "this is the logarithm: d digits are a factor 10^d in the error"},
           {std::pow(10.0, digits * p), "digits over p, not times p"}}});
}

// By the product of (09.13), with the lengths of steps as the unit of time, for the time 0.
void check_guess(int count) {
  VectorXd exact = VectorXd::Ones(count);
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      if (i != j) exact[j] *= (i + 1.0) / (i - j);
    }
  }
  VectorXd line = VectorXd::Zero(count);
  line[0] = count > 1 ? 2.0 : 1.0;
  if (count > 1) line[1] = -1.0;
  expect(
      {.what = "K = " + std::to_string(count),
       .got = guess_weights(count),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{exact.reverse().eval(), "the newest density comes first"},
                    {exact.cwiseAbs().eval(), "the signs alternate: the sum of the weights is 1"},
                    {VectorXd::Constant(count, 1.0 / count),
                     "the mean does not extrapolate: it is the density of an earlier time"},
                    {line, "this is the straight line through the last two densities"},
                    {VectorXd(-exact), "all signs are wrong: the sum of the weights is 1"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the error of Euler's step",
        .formula = "-(h^2/2) f' f",
        .hint = "Taylor's formula for the exact state, and the chain rule for its second term",
        .check =
            [] {
              for (const double q : {1.0, 2.0, -3.0}) check_error(q, 1e-4);
            }},
       {.title = "an order condition",
        .formula = "b_1 c_1 + b_2 c_2 = 1/2",
        .hint = "the first stage has c_1 = 0",
        .check =
            [] {
              for (const double c : {1.0, 0.5, 0.75}) check_weight(c);
            }},
       {.title = "the length that is allowed",
        .formula = "h e^(-1/m)",
        .hint = "e = C h^m, and 1 = C times the m-th power of the length",
        .check =
            [] {
              check_length(300.0, 0.5, 3);
              check_length(2000.0, 0.25, 5);
              check_length(0.01, 2.0, 2);
            }},
       {.title = "the price of digits",
        .formula = "10^(d/p)",
        .hint = "the error of a run falls like the power p of the number of steps",
        .check =
            [] {
              check_steps(1, 2.0);
              check_steps(2, 5.0);
              check_steps(5, 4.0);
            }},
       {.title = "weights of a guess",
        .formula = "(-1)^j binomial(K, j + 1) for j = 0 ... K - 1",
        .hint = "1; then 2, -1; then 3, -3, 1",
        .check = [] {
          for (const int count : {1, 2, 3, 5}) check_guess(count);
        }}});
}
