// Check of exercise 06.1: preimages by the map itself, predictions by sums over nodes.
#include "chapters/check.hpp"

#include <algorithm>
#include <numbers>

#include "near_singular/near_field.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

Complex preimage(const Ellipse& ellipse, Complex z);
int nodes_needed(const Ellipse& ellipse, Complex z, double tolerance);
Complex divisor(const Ellipse& ellipse, int n, Complex z);
double second_preimage(const Ellipse& ellipse);

namespace {

// x(t) continued to complex parameters.
Complex image(const Ellipse& ellipse, Complex t) {
  return ellipse.a * std::cos(t) + imaginary * ellipse.b * std::sin(t);
}

double log_ratio(const Ellipse& ellipse) {
  return std::log((ellipse.a + ellipse.b) / (ellipse.a - ellipse.b));
}

const std::vector<Ellipse> ellipses{{1.0, 0.5}, {2.0, 0.3}};

void check_preimage() {
  for (const Ellipse& ellipse : ellipses) {
    // Nearer to the axis than half of the distance of a point's two preimages.
    for (const double share : {0.4, 0.05, -0.05, -0.3, -2.0}) {
      for (const double t : {0.3, 2.0, -1.1}) {
        const Complex exact{t, share * log_ratio(ellipse)};
        // Their product w1 w2 = m e^0: the other one is -t + i (log(1/m) - Im).
        const Complex other{-t, log_ratio(ellipse) - exact.imag()};
        expect({.what = "an ellipse " + exercise::text(ellipse.a) + ", " +
                        exercise::text(ellipse.b) + ", the image of " + exercise::text(exact),
                .got = preimage(ellipse, image(ellipse, exact)),
                .expected = exact,
                .tolerance = 1e-12,
                .mistakes = {{other, "this is the other preimage, farther from the axis"},
                             {std::conj(exact),
                              "the imaginary part has the other sign: |exp(i tau)| = "
                              "exp(-Im tau)"},
                             {std::exp(imaginary * exact), "this is w, not tau"},
                             {std::abs(exact.imag()), "this is the distance, not tau"}}});
      }
    }
  }
}

void check_nodes() {
  for (const Ellipse& ellipse : ellipses) {
    for (const double tolerance : {1e-3, 1e-10}) {
      for (const double height : {0.05, -0.02, -0.4}) {
        const Complex z = image(ellipse, {0.7, height});
        const auto least = [&](double bound) {
          return 2.0 * std::ceil(0.5 * bound / std::abs(height));
        };
        expect({.what = "a preimage at " + exercise::text(height) + ", tolerance " +
                        exercise::text(tolerance),
                .got = static_cast<double>(nodes_needed(ellipse, z, tolerance)),
                .expected = least(near_cut(tolerance)),
                .tolerance = 0.0,
                .mistakes = {
                    {least(std::log10(200.0 / tolerance)), "the logarithm is the natural one"},
                    {least(-std::log(tolerance)), "the constant 200 is missing"},
                    {std::ceil(near_cut(tolerance) / std::abs(height)),
                     "the number of nodes has to be even"}}});
      }
    }
  }
}

// Delta by its definition.
Complex divisor_by_nodes(const Ellipse& ellipse, int n, Complex z) {
  const Curve curve = sample(ellipse, n, Side::fluid_outside);
  Complex sum = 1.0;
  for (Index j = 0; j < curve.size(); ++j) {
    sum -= curve.dx[j] / (imaginary * static_cast<double>(n) * (curve.x[j] - z));
  }
  return sum;
}

void check_divisor() {
  const Ellipse ellipse{1.0, 0.5};
  for (const int n : {40, 64}) {
    for (const double t : {0.3, 2.0, -1.13}) {
      for (const double depth : {3.0, 1.0, 0.1, 1e-3}) {
        const Complex z = image(ellipse, {t, -depth / n});
        const Complex exact = divisor_by_nodes(ellipse, n, z);
        expect(
            {.what = std::to_string(n) + " nodes, the image of " + exercise::text({t, -depth / n}),
             .got = divisor(ellipse, n, z),
             .expected = exact,
             .tolerance = 1e-9,
             .mistakes = {
                 {exact - 1.0, "this is the sum of the weights, without the 1 of a body"},
                 {1.0 - exact, "this is Delta of the fluid inside: exp(i N tau) grows outside"},
                 {std::conj(exact), "i has the other sign"}}});
      }
    }
  }
}

void check_second() {
  for (const Ellipse& ellipse : ellipses) {
    const double exact = log_ratio(ellipse);
    expect(
        {.what = "semi-axes " + exercise::text(ellipse.a) + ", " + exercise::text(ellipse.b),
         .got = second_preimage(ellipse),
         .expected = exact,
         .tolerance = 1e-12,
         .mistakes = {{0.5 * exact, "this is the distance of the foci's preimage, where both meet"},
                      {std::exp(-exact), "this is m, not log(1/m)"},
                      {-exact, "a distance is positive"}}});
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the preimage",
                         .formula = "(a + b)/2 w + (a - b)/2 /w = z, tau = -i log w",
                         .hint = "of the two solutions, the one whose modulus is nearer to 1",
                         .check = check_preimage},
                        {.title = "the nodes that a target needs",
                         .builds_on = {1},
                         .formula = "N = ln(200/eps)/|Im tau|, rounded up to an even number",
                         .hint = "natural logarithm; std::ceil of half of it, times two",
                         .check = check_nodes},
                        {.title = "the divisor",
                         .builds_on = {1},
                         .formula = "Delta = 1/(1 - q), |q| = exp(-N |Im tau|)",
                         .hint = "outside Im tau < 0: q = exp(-i N tau)",
                         .check = check_divisor},
                        {.title = "the second preimage",
                         .formula = "w1 w2 = (a - b)/(a + b), |w1| = 1",
                         .hint = "the distance of tau from the axis is |log|w||",
                         .check = check_second}});
}
