// Exercise 06.1: the preimage of a target, and what it predicts.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "trapezoid/plane.hpp"
#include "trapezoid/shape.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: x(tau) = z, tau as near to the real axis as can be, its real part in (-pi, pi].
Complex preimage(const Ellipse& ellipse, Complex z) {
  //@ starter
  not_done(ellipse, z);  // your code instead of this line
  //@ solution
  const double sum = ellipse.a + ellipse.b, difference = ellipse.a - ellipse.b;
  const Complex root = std::sqrt(z * z - sum * difference);
  const Complex w1 = (z + root) / sum, w2 = (z - root) / sum;
  const auto depth = [](Complex w) { return std::abs(std::log(std::abs(w))); };
  const Complex w = depth(w1) < depth(w2) ? w1 : w2;
  return {std::arg(w), -std::log(std::abs(w))};
  //@ wrong farther: this is the other preimage
  const double sum = ellipse.a + ellipse.b, difference = ellipse.a - ellipse.b;
  const Complex root = std::sqrt(z * z - sum * difference);
  const Complex w1 = (z + root) / sum, w2 = (z - root) / sum;
  const auto depth = [](Complex w) { return std::abs(std::log(std::abs(w))); };
  const Complex w = depth(w1) < depth(w2) ? w2 : w1;
  return {std::arg(w), -std::log(std::abs(w))};
  //@ wrong conjugate: the imaginary part has the other sign
  const double sum = ellipse.a + ellipse.b, difference = ellipse.a - ellipse.b;
  const Complex root = std::sqrt(z * z - sum * difference);
  const Complex w1 = (z + root) / sum, w2 = (z - root) / sum;
  const auto depth = [](Complex w) { return std::abs(std::log(std::abs(w))); };
  const Complex w = depth(w1) < depth(w2) ? w1 : w2;
  return {std::arg(w), std::log(std::abs(w))};
  //@ end
}

// Task 2: the least even N with N |Im tau| >= ln(200/eps).
int nodes_needed(const Ellipse& ellipse, Complex z, double tolerance) {
  //@ starter
  not_done(ellipse, z, tolerance);  // your code instead of this line
  //@ solution
  const double nodes = std::log(200.0 / tolerance) / std::abs(preimage(ellipse, z).imag());
  return 2 * static_cast<int>(std::ceil(0.5 * nodes));
  //@ wrong decades: the logarithm is the natural one
  const double nodes = std::log10(200.0 / tolerance) / std::abs(preimage(ellipse, z).imag());
  return 2 * static_cast<int>(std::ceil(0.5 * nodes));
  //@ end
}

// Task 3: Delta of n nodes at a target outside, where the fluid is, by the nearest preimage.
Complex divisor(const Ellipse& ellipse, int n, Complex z) {
  //@ starter
  not_done(ellipse, n, z);  // your code instead of this line
  //@ solution
  const Complex q = std::exp(-imaginary * static_cast<double>(n) * preimage(ellipse, z));
  return 1.0 / (1.0 - q);
  //@ wrong without_one: this is the sum of the weights, without the 1 of a body
  const Complex q = std::exp(-imaginary * static_cast<double>(n) * preimage(ellipse, z));
  return q / (1.0 - q);
  //@ wrong inside: this is Delta of the fluid inside
  const Complex q = std::exp(-imaginary * static_cast<double>(n) * preimage(ellipse, z));
  return 1.0 / (1.0 - 1.0 / q);
  //@ end
}

// Task 4: |Im| of the second preimage of a point of the curve.
double second_preimage(const Ellipse& ellipse) {
  //@ starter
  not_done(ellipse);  // your code instead of this line
  //@ solution
  return std::log((ellipse.a + ellipse.b) / (ellipse.a - ellipse.b));
  //@ wrong focus: this is the distance of the foci
  return 0.5 * std::log((ellipse.a + ellipse.b) / (ellipse.a - ellipse.b));
  //@ end
}
