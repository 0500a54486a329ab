// Check of exercise 06.4: the reader's lines against sums over nodes, stresslets and closed forms.
#include "chapters/check.hpp"

#include <numbers>

#include "double_layer/kernels.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

Complex pole_error(Complex tau, int n);
Complex velocity(Complex z, Complex phi, Complex dphi, Complex psi);
Complex along_curve(Complex df, Complex dx);
bool in_the_fluid(Complex sum, Side side);
double gap_depth(double gap, double radius);

namespace {

void check_pole(Complex tau, int n) {
  Complex sum = 0.0;
  for (int j = 0; j < n; ++j) sum += 0.5 / std::tan(0.5 * (2.0 * pi * j / n - tau));
  const double integral = tau.imag() > 0.0 ? 0.5 : -0.5;
  const Complex rule = sum / (imaginary * static_cast<double>(n)), exact = rule - integral;
  const double q = std::exp(-n * std::abs(tau.imag()));
  expect(
      {.what = "tau = " + exercise::text(tau) + ", N = " + std::to_string(n),
       .got = pole_error(tau, n),
       .expected = exact,
       .tolerance = 1e-10,
       .mistakes = {{rule - 0.5, "below the real axis the integral is -1/2"},
                    {std::copysign(q / (1.0 - q), tau.imag()),
                     "this is right for a target next to a node: q has a phase, which is missing"},
                    {-exact, "this is integral minus rule: the sign is the other one"},
                    {rule, "this is the rule itself, without the integral"},
                    {exact + 1.0, "the error vanishes far from the axis; this does not"}}});
}

// The stresslet of one source at x, in Goursat's form.
void check_velocity(Complex z) {
  const Complex x{0.3, -0.2}, n = std::polar(1.0, 0.7), eta{0.9, 1.3}, r = z - x;
  const Complex phi = n * eta / (4.0 * pi * r), dphi = -phi / r;
  const Complex psi = -(2.0 * dot(n, eta) / r - std::conj(x) * n * eta / (r * r)) / (4.0 * pi);
  const Complex exact = stresslet(r, n, eta);
  expect({.what = "a stresslet at 0.3 - 0.2i, z = " + exercise::text(z),
          .got = velocity(z, phi, dphi, psi),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{exact + std::conj(psi) - psi, "psi must be conjugate"},
                       {exact + z * std::conj(dphi) - std::conj(z) * dphi,
                        "z itself stands in front, and phi' is conjugate"},
                       {2.0 * phi - exact, "the signs of the last two terms are the other ones"},
                       {exact + z * std::conj(dphi) - z * dphi, "phi' must be conjugate"}}});
}

// x^k for positive k, and the k-th power of conj(x) for negative k, along an ellipse.
void check_derivative(int power, double t) {
  const Complex x{2.0 * std::cos(t), std::sin(t)}, dx{-2.0 * std::sin(t), std::cos(t)};
  const int k = std::abs(power);
  const Complex slope = static_cast<double>(k) * std::pow(power > 0 ? x : std::conj(x), k - 1);
  const Complex direction = std::conj(dx) / dx;
  const Complex exact = power > 0 ? slope : slope * direction;
  const Complex df = power > 0 ? slope * dx : slope * std::conj(dx);
  const double speed = std::abs(dx);
  expect({.what = (power > 0 ? "x^" : "conj(x)^") + std::to_string(k) +
                  " on an ellipse 2:1, t = " + exercise::text(t),
          .got = along_curve(df, dx),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {df / speed, "this is the derivative with respect to the arclength: divide by x'"},
              {df / std::conj(dx), "this divides by the conjugate"},
              {df, "this is the derivative with respect to t"},
              {df * dx, "this multiplies by x'"}}});
}

// A circle and targets from far inside to far outside, over a node and between two nodes.
void check_side(Side side, double radius, const std::vector<double>& distances) {
  constexpr Eigen::Index nodes = 32;
  const Curve curve = sample(Circle{radius}, nodes, side);
  const double sign = curve.sign();
  const Eigen::Index count = static_cast<Eigen::Index>(2 * distances.size());
  ComplexVector got(count), exact(count), bare(count), modulus(count), always(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double distance = distances[static_cast<std::size_t>(k / 2)];
    const Complex z = std::polar(radius + distance, k % 2 == 0 ? 0.01 : pi / nodes);
    const ComplexVector terms = curve.dx.array() / (curve.x.array() - z);
    const Complex sum = sign / (imaginary * static_cast<double>(nodes)) * terms.sum();
    const double one = side == Side::fluid_outside ? 1.0 : 0.0;
    got[k] = in_the_fluid(sum, side);
    exact[k] = (distance > 0.0) == (side == Side::fluid_outside);
    bare[k] = sum.real() > 0.5;
    modulus[k] = std::abs(one + sum) > 0.5;
    always[k] = sum.real() > -0.5;
  }
  expect(
      {.what = (side == Side::fluid_outside ? "a body" : "a wall") + std::string(" of radius ") +
               exercise::text(radius) + ", 1 where a target is in the fluid",
       .got = got,
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{bare, "the 1 of a body is missing"},
                    {modulus, "this takes the modulus, which is large on both sides near a node"},
                    {always, "the sum of a wall needs no 1"},
                    {(1.0 - exact.array()).matrix(), "this is the other side"}}});
}

void check_gap(double gap, double radius) {
  const double half = 0.5 * gap / radius;
  const double exact = std::log1p(half + std::sqrt(half * (2.0 + half)));
  expect({.what = "g = " + exercise::text(gap) + ", R = " + exercise::text(radius),
          .got = gap_depth(gap, radius),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {
              {std::acosh(1.0 + half), "the sum rounds off digits of the gap: use 2 sinh^2(d/2)"},
              {std::sqrt(gap / radius), "this holds for small gaps only"},
              {2.0 * std::asinh(std::sqrt(gap / 4.0)),
               "this is the depth for circles of radius 1: divide the gap by R"},
              {0.5 * exact, "the half angle gives d/2"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the error of a pole",
        .formula = "q/(1 - q) above the axis and 1/(1 - q) below it, q = exp(iN tau)",
        .hint = "the integral is 1/2 above the axis and -1/2 below it",
        .check =
            [] {
              check_pole({0.4, 0.1}, 8);
              check_pole({1.1, 0.05}, 20);
              check_pole({0.7, -0.2}, 8);
              check_pole({2.0, -0.03}, 20);
            }},
       {.title = "the velocity",
        .formula = "phi - z conj(phi') - conj(psi)",
        .hint = "only phi is not conjugate",
        .check =
            [] {
              for (const Complex z : {Complex{1.0, 0.5}, Complex{-0.4, 0.6}, Complex{2.0, -3.0}}) {
                check_velocity(z);
              }
            }},
       {.title = "the derivative along the curve",
        .formula = "df/dx = (df/dt) / x'",
        .hint = "x' is a complex number",
        .check =
            [] {
              for (const int power : {2, 3, -1, -2}) {
                check_derivative(power, 0.6);
                check_derivative(power, 2.5);
              }
            }},
       {.title = "the side test",
        .formula = "Re Delta > 1/2",
        .hint = "1/(1 - q) with |q| < 1 lies to the right of 1/2",
        .check =
            [] {
              for (const Side side : {Side::fluid_outside, Side::fluid_inside}) {
                check_side(side, 1.0, {-0.5, -0.1, -0.01, 0.01, 0.1, 0.5});
                check_side(side, 2.0, {-1.0, -0.02, 0.02, 1.0});
              }
            }},
       {.title = "the depth at a gap",
        .formula = "2 arsinh of the root of g/(4R)",
        .hint = "cosh d - 1 = 2 sinh^2(d/2)",
        .check = [] {
          check_gap(1.0, 1.0);
          check_gap(0.1, 2.0);
          check_gap(3e-7, 0.5);
          check_gap(1e-12, 1.0);
          check_gap(4e-11, 3.0);
        }}});
}
