// Check of exercise 08.4: series, velocities, conditions and derivatives against closed forms.
#include "chapters/check.hpp"

#include <algorithm>
#include <numbers>

using namespace stokesbook;
using exercise::expect;
using exercise::text;

Complex part_left_out(Complex z, Complex y, Complex c, int p);
Complex psi_about(Complex new_centre, Complex old_centre, Complex psi, Complex phi_prime);
double least_distance(double source_radius, double target_radius, double rho);
Complex shifted_coefficient(Complex D, int k, int l);
double best_boxes(double nodes, double order);

namespace {

// Returns where a function that grows from below zero has its zero, between two numbers > 0.
template <class Function>
double zero(const Function& function, double low, double high) {
  for (int bisection = 0; bisection < 200; ++bisection) {
    const double middle = 0.5 * (low + high);
    (function(middle) < 0.0 ? low : high) = middle;
  }
  return low;
}

void check_part(Complex z, Complex y, Complex c, int p) {
  Complex sum = 0.0;
  for (int k = 1; k <= p; ++k) sum += std::pow(y - c, k - 1) / std::pow(z - c, k);
  const Complex exact = 1.0 - (z - y) * sum, q = (y - c) / (z - c);
  expect({.what = "z = " + text(z) + ", y = " + text(y) + ", c = " + text(c) +
                  ", p = " + std::to_string(p),
          .got = part_left_out(z, y, c, p),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {
              {exact * q,
               "the sum begins with the power 0 of q = (y - c)/(z - c), so that the first power "
               "of q that is left out is p"},
              {exact / std::pow((z - y) / (z - c), p),
               "this has the distance of the target from the source; the terms have its distance "
               "from the centre"},
              {std::pow(std::abs(q), p), "this is the bound: the difference is a complex number"},
              {exact / (z - y), "this is the difference, not its part of 1/(z - y)"}}});
}

// The velocity at z, by the old centre, determines psi of the new one.
void check_psi(Complex from, Complex to, Complex psi) {
  const Complex z{0.7, -1.3}, phi{0.4, 0.9}, slope{-0.6, 0.8};
  const Complex u = phi - (z - from) * std::conj(slope) - std::conj(psi);
  const Complex exact = std::conj(phi - (z - to) * std::conj(slope) - u);
  const Complex change = exact - psi;
  expect(
      {.what = "centres " + text(from) + " and " + text(to) + ", psi = " + text(psi) +
               ", phi' = " + text(slope),
       .got = psi_about(to, from, psi, slope),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{psi - change,
                     "this moves the centre the other way: the difference is the new "
                     "centre minus the old one"},
                    {psi + (to - from) * slope, "the difference of the centres is conjugate here"},
                    {psi, "psi changes, because z - c has changed and the velocity has not"}}});
}

void check_distance(double s, double t, double rho) {
  const auto separated = [&](double d) { return std::min(rho * (d - t) - s, rho * (d - s) - t); };
  expect({.what = "R_s = " + text(s) + ", R_t = " + text(t) + ", rho = " + text(rho),
          .got = least_distance(s, t, rho),
          .expected = zero(separated, s + t, 100.0),
          .tolerance = 1e-12,
          .mistakes = {{s / rho + t,
                        "the local expansion has a condition too: no source may be "
                        "near the centre of the targets"},
                       {t / rho + s,
                        "the multipole expansion has a condition too: no target may "
                        "be near the centre of the sources"},
                       {std::max(s, t) / rho,
                        "this compares with the distance of the two centres; the nearest target "
                        "is nearer"},
                       {(s + t) / rho, "this divides both radii by rho: one is enough"}}});
}

// By the trapezoid rule on a circle about x = 0.
void check_coefficient(Complex D, int k, int l) {
  constexpr int n = 64;
  const double radius = 0.25 * std::abs(D);
  Complex sum = 0.0;
  for (int j = 0; j < n; ++j) {
    const Complex turn = std::polar(1.0, 2.0 * std::numbers::pi * j / n);
    sum += std::pow(D + radius * turn, -k) * std::pow(turn, -l);
  }
  double positive = 1.0;  // binomial of k and l
  for (int i = 1; i <= l; ++i) positive *= (k - i + 1.0) / i;
  const Complex exact = sum / (n * std::pow(radius, l));
  expect(
      {.what = "D = " + text(D) + ", k = " + std::to_string(k) + ", l = " + std::to_string(l),
       .got = shifted_coefficient(D, k, l),
       .expected = exact,
       .tolerance = 1e-10,
       .mistakes = {{l % 2 == 0 ? exact : -exact,
                     "each derivative of a negative power changes the sign: (-1)^l is missing"},
                    {positive * std::pow(D, -k - l),
                     "this has the coefficients of the power k; for -k they are (-1)^l times the "
                     "binomial of k + l - 1 and l"},
                    {exact * (1.0 + static_cast<double>(l) / k),
                     "this has the binomial of k + l and l: it is that of "
                     "k + l - 1 and l"},
                    {exact * std::pow(D, k + l), "the power of D is missing"}}});
}

void check_boxes(double n, double p) {
  const auto slope = [&](double beta) { return p * p * beta - 13.0 * n * n / (beta * beta); };
  const double exact = zero(slope, 1e-3, 1e9);
  expect(
      {.what = "N = " + text(n) + ", p = " + text(p),
       .got = best_boxes(n, p),
       .expected = exact,
       .tolerance = 1e-10,
       .mistakes = {{std::cbrt(2.0) * exact,
                     "here the two terms are equal; their sum is least where "
                     "their derivatives cancel"},
                    {exact / std::cbrt(2.0), "the derivative of beta^2/2 is beta, without a half"},
                    {exact / std::cbrt(13.0), "the 13 near boxes are missing"},
                    {13.0 * n * n / p + 0.5 * p * p * exact * exact,
                     "these are operations: the task asks for the number of boxes"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "what an expansion leaves out",
        .formula = "q^p with q = (y - c)/(z - c)",
        .hint = "a finite geometric series: 1 + q + ... + q^(p-1) = (1 - q^p)/(1 - q)",
        .check =
            [] {
              check_part({2.0, 0.0}, {0.5, 0.0}, {0.0, 0.0}, 3);
              check_part({2.0, 1.0}, {0.3, -0.8}, {0.1, 0.2}, 1);
              check_part({-1.5, 2.0}, {0.6, 0.2}, {0.5, -0.5}, 4);
            }},
       {.title = "another centre",
        .formula = "psi_c' = psi_c + conj(c' - c) phi'",
        .hint = "the velocity phi - (z - c) conj(phi') - conj(psi_c) is the same for both centres",
        .check =
            [] {
              check_psi({0.0, 0.0}, {2.0, 1.0}, {0.5, -0.25});
              check_psi({1.0, -1.0}, {-0.5, 3.0}, {1.5, 0.75});
            }},
       {.title = "the distance of two boxes",
        .formula = "R_s < rho (D - R_t) and R_t < rho (D - R_s)",
        .hint = "solve both conditions for D, and take the larger result",
        .check =
            [] {
              check_distance(1.0, 1.0, 0.5);
              check_distance(1.0, 2.0, 0.5);
              check_distance(3.0, 1.0, 0.5);
              check_distance(0.5, 1.5, 0.4);
            }},
       {.title = "a shifted power",
        .formula = "(-1)^l binomial(k + l - 1, l) D^(-k-l)",
        .hint = "the l-th derivative of (D + x)^-k at x = 0, divided by l!",
        .check =
            [] {
              check_coefficient({2.0, 0.5}, 1, 1);
              check_coefficient({1.0, 1.0}, 2, 3);
              check_coefficient({-0.5, 2.0}, 3, 2);
            }},
       {.title = "the number of boxes",
        .formula = "beta^3 = 13 N^2/p^2",
        .hint = "-13 N^2/beta^2 + p^2 beta = 0",
        .check = [] {
          for (const double n : {1000.0, 64000.0}) {
            for (const double p : {6.0, 20.0}) check_boxes(n, p);
          }
        }}});
}
