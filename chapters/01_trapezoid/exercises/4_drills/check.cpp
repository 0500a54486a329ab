// Check of exercise 01.4: the reader's lines against closed forms of ellipses and of one integrand.
#include "chapters/check.hpp"

#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

Complex normal(Complex dx, Side side);
double curvature(Complex dx, Complex ddx);
double integral(const Eigen::VectorXd& values);
int wave_number(int k, int n);
double perimeter_rate(double a, double b);

namespace {

std::string at(double t) {
  return ", t = " + exercise::text(t);
}

// The ellipse x = (2 cos t, sin t): its outward normal is the gradient of x^2/4 + y^2.
void check_normal(double t, Side side) {
  const Complex gradient{0.5 * std::cos(t), std::sin(t)};
  const Complex outward = gradient / std::abs(gradient);
  const Complex exact = side == Side::fluid_inside ? outward : -outward;
  const Complex dx{-2.0 * std::sin(t), std::cos(t)};
  const std::string where = side == Side::fluid_inside ? "inside" : "outside";
  expect({.what = "fluid " + where + " the ellipse 2:1" + at(t),
          .got = normal(dx, side),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {outward,
               "this normal points out of the curve; out of the fluid is the other way at a body"},
              {-outward, "this normal points into the curve; at a wall the fluid is there"},
              {-exact, "this normal points into the fluid"},
              {exact * std::abs(dx), "this is not a unit vector"},
              {dx / std::abs(dx), "this is the tangent"}}});
}

// The limacon r = 1 + A cos t, which is concave about t = pi for A > 1/2.
void check_curvature(double amplitude, double t) {
  const double r = 1.0 + amplitude * std::cos(t), dr = -amplitude * std::sin(t), ddr = 1.0 - r;
  const Complex direction = std::polar(1.0, t);
  const Complex dx = (dr + imaginary * r) * direction;
  const Complex ddx = (ddr - r + 2.0 * imaginary * dr) * direction;
  const double speed = std::sqrt(r * r + dr * dr);
  const double exact = (r * r + 2.0 * dr * dr - r * ddr) / std::pow(speed, 3);
  expect({.what = "r = 1 + " + exercise::text(amplitude) + " cos t" + at(t),
          .got = curvature(dx, ddx),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{exact * speed,
                        "this is the turn of the tangent per unit of t; divide by |x'| once more"},
                       {std::abs(ddx) / (speed * speed),
                        "this is right if t is the arclength: x'' also changes the speed"},
                       {-exact, "the sign is the other one"},
                       {std::abs(exact), "this is positive where the curve is concave"}}});
}

// 1/(1 - a cos t), whose aliases are below rounding.
void check_integral(double a) {
  constexpr int n = 64;
  Eigen::VectorXd values(n + 1);
  for (int j = 0; j <= n; ++j) values[j] = 1.0 / (1.0 - a * std::cos(2.0 * pi * j / n));
  const double exact = 2.0 * pi / std::sqrt(1.0 - a * a), first = 2.0 * pi / n * values[0];
  expect({.what = "1/(1 - " + exercise::text(a) + " cos t), N = 64",
          .got = integral(values),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{exact + first, "the first node counts twice: t = 0 and 2 pi are one point"},
                       {(exact + first) * n / (n + 1.0),
                        "the mean contains the first node twice: there are N nodes"},
                       {exact * n / (n + 1.0), "the spacing is 2 pi/N, not 2 pi/(N + 1)"},
                       {exact / (2.0 * pi), "this is the mean: the length 2 pi is missing"}}});
}

void check_wave_number(int k, int n) {
  int exact = -n / 2;
  while ((k - exact) % n != 0) ++exact;
  const double got = wave_number(k, n);
  expect({.what = "k = " + std::to_string(k) + ", N = " + std::to_string(n),
          .got = got,
          .expected = static_cast<double>(exact),
          .tolerance = 1e-12,
          .mistakes = {
              {exact < 0 ? exact + n : exact,
               "these wave numbers run from 0 to N - 1: the upper half are negative ones"},
              {(k + n / 2) % n - n / 2, "the remainder of a negative number is negative in C++"},
              {exact == -n / 2 ? n / 2 : exact, "the wave number N/2 counts as -N/2"},
              {k, "this is k itself, which may be too large"}}});
}

void check_rate(double a, double b) {
  const double exact = 0.5 * std::log((a + b) / std::abs(a - b));
  const double ratio = std::min(a, b) / std::max(a, b);
  expect(
      {.what = "a = " + exercise::text(a) + ", b = " + exercise::text(b),
       .got = perimeter_rate(a, b),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{ratio, "this holds for slender ellipses only: the exact rate is the artanh"},
                    {2.0 * exact, "this is the rate of the kernel, in which m = exp(-2d)"},
                    {std::tanh(ratio), "this is the tanh, not its inverse"},
                    {std::atan(ratio), "this is the arc tangent: the zero is not a real t"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the normal",
                         .formula = "n = -i s x'/|x'|",
                         .hint = "-i x' points out of a counter-clockwise curve",
                         .check =
                             [] {
                               for (const double t : {0.3, 2.0, 4.5}) {
                                 check_normal(t, Side::fluid_inside);
                                 check_normal(t, Side::fluid_outside);
                               }
                             }},
                        {.title = "the curvature",
                         .formula = "kappa = (x' cross x'')/|x'|^3",
                         .hint = "a circle of radius R has 1/R, however fast t runs",
                         .check =
                             [] {
                               for (const double amplitude : {0.2, 0.8}) {
                                 for (const double t : {0.5, 2.0, 3.1}) {
                                   check_curvature(amplitude, t);
                                 }
                               }
                             }},
                        {.title = "the integral over a period",
                         .formula = "2 pi/N times the sum over N different nodes",
                         .hint = "the last value belongs to the same point as the first one",
                         .check =
                             [] {
                               for (const double a : {0.2, 0.5, 0.8}) check_integral(a);
                             }},
                        {.title = "the wave number",
                         .formula = "m = k + lN with an integer l",
                         .hint = "count from -N/2, take the remainder, and count back",
                         .check =
                             [] {
                               for (const int k : {0, 3, 5, 7, 8, 12, 21, -3, -8, -9, -13, -24}) {
                                 check_wave_number(k, 8);
                                 check_wave_number(k, 10);
                               }
                             }},
                        {.title = "the rate of a perimeter",
                         .formula = "tanh d = short axis / long axis",
                         .hint = "d is the distance of a zero of |x'|^2 from the real axis",
                         .check = [] {
                           check_rate(2.0, 1.0);
                           check_rate(1.0, 3.0);
                           check_rate(5.0, 4.0);
                         }}});
}
