// Check of exercise 12.4: means, bisections and steps against closed forms.
#include "chapters/check.hpp"

#include <limits>

using namespace stokesbook;
using Eigen::Matrix2d;
using exercise::expect;
using exercise::text;

double background_turn(const Matrix2d& G);
double decay_rate(double gap, double radius);
double gap_after(double start, double c, double time);
double least_gap(double digits);
double heun_drift(double radius, double theta);

namespace {

// The mean velocity along a circle about the body, over its radius; four points are enough.
void check_turn(const Matrix2d& G) {
  double exact = 0.0;
  for (const Complex d : {Complex(1.0), imaginary, Complex(-1.0), -imaginary}) {
    const Complex u{G(0, 0) * d.real() + G(0, 1) * d.imag(),
                    G(1, 0) * d.real() + G(1, 1) * d.imag()};
    exact += 0.25 * dot(u, perp(d));
  }
  expect({.what = "G = (" + text(G(0, 0)) + ", " + text(G(0, 1)) + "; " + text(G(1, 0)) + ", " +
                  text(G(1, 1)) + ")",
          .got = background_turn(G),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {{2.0 * exact, "this is the vorticity: a body turns with half of it"},
                       {-exact, "this turns the other way: counter-clockwise is positive"},
                       {-2.0 * exact,
                        "this is minus the vorticity: a body turns with half of the vorticity, "
                        "and counter-clockwise is positive"},
                       {0.5 * (G(0, 1) + G(1, 0)), "this is an entry of the straining part"}}});
}

// The circles are level lines of |(z + f)/(z - f)|, and the logarithm of the level is alpha.
void check_rate(double gap, double radius) {
  const double half = radius + 0.5 * gap, focus = std::sqrt(half * half - radius * radius);
  const double point = half - radius;  // the point of a circle that is nearest to the other circle
  const double exact = std::log((focus + point) / (focus - point));
  expect({.what = "g = " + text(gap) + ", a = " + text(radius),
          .got = decay_rate(gap, radius),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {
              {std::acosh(1.0 + gap / radius),
               "half of the distance contains half of the gap: a + g/2"},
              {std::acosh(1.0 + 0.5 * gap), "a rate has no unit: divide by the radius"},
              {std::sqrt(gap / radius), "this is the limit for narrow gaps, not the exact rate"}}});
}

// By many steps of the classical method of Runge and Kutta.
void check_gap(double start, double c, double time) {
  constexpr int steps = 2000;
  const auto rate = [&](double g) { return -c * g * std::sqrt(g); };
  const double h = time / steps;
  double g = start;
  for (int k = 0; k < steps; ++k) {
    const double k1 = rate(g), k2 = rate(g + 0.5 * h * k1), k3 = rate(g + 0.5 * h * k2);
    g += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + rate(g + h * k3));
  }
  const double root = 1.0 / std::sqrt(start);
  expect(
      {.what = "gap " + text(start) + " at the start, c = " + text(c) + ", time " + text(time),
       .got = gap_after(start, c, time),
       .expected = g,
       .tolerance = 1e-8,
       .mistakes = {
           {std::pow(root - 0.5 * c * time, -2.0),
            "this gap becomes wider: the force presses the circles together"},
           {std::pow(root + c * time, -2.0),
            "the integral of the power -3/2 is -2 times the power -1/2"},
           {start - c * start / root * time,
            "this keeps the rate at the start, and the circles would touch; the rate falls with "
            "the gap"},
           {start * std::exp(-c * time), "this is the gap for a rate in proportion to the gap"}}});
}

void check_least(double digits) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double low = 1e-14, high = 1.0;
  for (int bisection = 0; bisection < 200; ++bisection) {
    const double middle = std::sqrt(low * high);
    (epsilon / (middle * std::sqrt(middle)) > std::pow(10.0, -digits) ? low : high) = middle;
  }
  const double product = low * std::sqrt(low);
  expect({.what = text(digits) + " digits",
          .got = least_gap(digits),
          .expected = low,
          .tolerance = 1e-9,
          .mistakes = {{product * std::sqrt(product),
                        "solve for the gap: the inverse of the power 3/2 is the power 2/3"},
                       {std::pow(10.0, -2.0 / 3.0 * digits),
                        "these are digits that are lost, g^(-3/2) = 10^d: epsilon is missing"},
                       {product, "this is g^(3/2): take the power 2/3"}}});
}

// By one step of Heun's method.
void check_drift(double radius, double theta) {
  const Complex q = radius, euler = q + theta * imaginary * q;
  const Complex heun = q + 0.5 * theta * (imaginary * q + imaginary * euler);
  expect({.what = "r = " + text(radius) + ", theta = " + text(theta),
          .got = heun_drift(radius, theta),
          .expected = std::abs(heun) - radius,
          .tolerance = 1e-8,
          .mistakes = {{std::abs(euler) - radius, "this is the drift of Euler's method"},
                       {radius * (std::norm(heun / radius) - 1.0),
                        "this has the square of the factor: take the root"},
                       {radius * (std::abs(Complex(1.0 - theta * theta, theta)) - 1.0),
                        "the second term of Heun's factor has a half"},
                       {0.125 * radius * std::pow(theta, 4.0),
                        "this is the leading term; the task asks for all of it"},
                       {std::abs(heun), "this is the distance: the task asks for its growth"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the turn of a background flow",
                         .formula = "(G_21 - G_12)/2",
                         .hint = "the antisymmetric part of G is a rotation",
                         .check =
                             [] {
                               check_turn(Matrix2d{{0.0, 1.0}, {0.0, 0.0}});
                               check_turn(Matrix2d{{0.5, -0.75}, {2.0, -0.5}});
                             }},
                        {.title = "modes at a gap",
                         .formula = "acosh(1 + g/(2a))",
                         .hint = "half of the distance of the centres is a + g/2",
                         .check =
                             [] {
                               check_rate(0.5, 1.0);
                               check_rate(0.1, 2.0);
                               check_rate(1.0, 0.5);
                             }},
                        {.title = "a film that is squeezed",
                         .formula = "g^(-1/2) = g_0^(-1/2) + c t/2",
                         .hint = "integrate both sides of g^(-3/2) dg = -c dt",
                         .check =
                             [] {
                               check_gap(0.25, 1.0, 3.0);
                               check_gap(1.0, 0.5, 1.0);
                             }},
                        {.title = "the limit of double precision",
                         .formula = "epsilon g^(-3/2) = 10^(-d)",
                         .hint = "solve for g",
                         .check =
                             [] {
                               for (const double digits : {3.0, 6.0}) check_least(digits);
                             }},
                        {.title = "the drift of Heun's method",
                         .formula = "r (sqrt(1 + theta^4/4) - 1)",
                         .hint = "the modulus of 1 + i theta - theta^2/2",
                         .check = [] {
                           check_drift(1.0, 0.5);
                           check_drift(3.0, 0.25);
                           check_drift(0.5, 1.0);
                         }}});
}
