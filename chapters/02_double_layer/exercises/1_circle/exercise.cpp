// Exercise 02.1: everything about the double layer on a circle.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

//@ starter
//@ solution
double sign_of(Side side) {
  return static_cast<double>(side);
}

//@ end
// Task 1: c of the kernel's limit c t (t.eta) on its own node, for any smooth curve.
double diagonal(Complex dx, Complex ddx, Side side) {
  //@ starter
  not_done(dx, ddx, side);  // your code instead of this line
  //@ solution
  return -sign_of(side) * cross(dx, ddx) / std::pow(std::abs(dx), 3) / (2.0 * pi);
  //@ wrong curvature_sign: the sign is the other one
  return sign_of(side) * cross(dx, ddx) / std::pow(std::abs(dx), 3) / (2.0 * pi);
  //@ wrong straight_normal: twice the limit
  return -sign_of(side) * cross(dx, ddx) / std::pow(std::abs(dx), 3) / pi;
  //@ end
}

// Task 2: the kernel on the unit circle, target exp(i alpha), source exp(i beta).
Complex circle_kernel(double alpha, double beta, Complex eta, Side side) {
  //@ starter
  not_done(alpha, beta, eta, side);  // your code instead of this line
  //@ solution
  return -sign_of(side) / (4.0 * pi) * (eta - std::polar(1.0, alpha + beta) * std::conj(eta));
  //@ wrong radial_chord: the chord is at right angles
  return -sign_of(side) / (4.0 * pi) * (eta + std::polar(1.0, alpha + beta) * std::conj(eta));
  //@ end
}

// Task 3: D eta at exp(i alpha) on the unit circle, from two modes of eta.
Complex layer_on_circle(double alpha, Complex eta_0, Complex eta_1, Side side) {
  //@ starter
  not_done(alpha, eta_0, eta_1, side);  // your code instead of this line
  //@ solution
  return -0.5 * sign_of(side) * (eta_0 - std::polar(1.0, alpha) * std::conj(eta_1));
  //@ wrong forgotten_conjugate: eta_1 without its conjugate
  return -0.5 * sign_of(side) * (eta_0 - std::polar(1.0, alpha) * eta_1);
  //@ end
}

// Task 4: mode k of the smallest density with -eta/2 + D eta = u inside the unit circle.
Complex density_mode(int k, Complex u_k) {
  //@ starter
  not_done(k, u_k);  // your code instead of this line
  //@ solution
  if (k == 0) return -u_k;
  if (k == 1) return {0.0, -u_k.imag()};
  return -2.0 * u_k;
  //@ wrong jump_only: this inverts the jump alone
  static_cast<void>(k);
  return -2.0 * u_k;
  //@ end
}
