// Exercise 01.1: the exact error of the trapezoid rule for f(t) = 1 / (1 - a cos t), 0 < a < 1.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

using std::numbers::pi;
using stokesbook::exercise::not_done;

//@ starter
//@ solution
// The root inside the unit circle of r^2 - (2/a) r + 1 = 0.
double decay(double a) {
  return (1.0 - std::sqrt(1.0 - a * a)) / a;
}

//@ end
// Task 1: Fourier coefficient of f of any wave number k.
double fourier_coefficient(double a, int k) {
  //@ starter
  not_done(a, k);  // your code instead of this line
  //@ solution
  return std::pow(decay(a), std::abs(k)) / std::sqrt(1.0 - a * a);
  //@ wrong growing_root: this takes the root outside the unit circle
  return std::pow(1.0 / decay(a), std::abs(k)) / std::sqrt(1.0 - a * a);
  //@ wrong negative_wave_numbers: this grows for negative wave numbers
  return std::pow(decay(a), k) / std::sqrt(1.0 - a * a);
  //@ end
}

// Task 2: what the discrete Fourier transform of n nodes returns for wave number k, 0 <= k < n.
double folded_coefficient(double a, int k, int n) {
  //@ starter
  not_done(a, k, n);  // your code instead of this line
  //@ solution
  const double r = decay(a);
  return (std::pow(r, k) + std::pow(r, n - k)) / (1.0 - std::pow(r, n)) / std::sqrt(1.0 - a * a);
  //@ wrong one_sided_folding: only k, k + N, k + 2N, ... are added up here
  return std::pow(decay(a), k) / (1.0 - std::pow(decay(a), n)) / std::sqrt(1.0 - a * a);
  //@ end
}

// Task 3: rule minus integral, over one period, with n nodes.
double trapezoid_error(double a, int n) {
  //@ starter
  not_done(a, n);  // your code instead of this line
  //@ solution
  const double folded = std::pow(decay(a), n);
  return 4.0 * pi * folded / (1.0 - folded) / std::sqrt(1.0 - a * a);
  //@ wrong half_of_the_modes: this is half of the error
  const double folded = std::pow(decay(a), n);
  return 2.0 * pi * folded / (1.0 - folded) / std::sqrt(1.0 - a * a);
  //@ wrong forgotten_period: this is the error of the mean
  const double folded = std::pow(decay(a), n);
  return 2.0 * folded / (1.0 - folded) / std::sqrt(1.0 - a * a);
  //@ end
}

// Task 4: least number of nodes with an error of at most tolerance times the integral.
int nodes_needed(double a, double tolerance) {
  //@ starter
  not_done(a, tolerance);  // your code instead of this line
  //@ solution
  return static_cast<int>(std::ceil(std::log(tolerance / (2.0 + tolerance)) / std::log(decay(a))));
  //@ wrong twice_the_rate: this takes r^(2N) for the error
  return static_cast<int>(std::ceil(0.5 * std::log(tolerance / 2.0) / std::log(decay(a))));
  //@ wrong rounded: rounded down
  return static_cast<int>(std::lround(std::log(tolerance / 2.0) / std::log(decay(a))));
  //@ end
}
