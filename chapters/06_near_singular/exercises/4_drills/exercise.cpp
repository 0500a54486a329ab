// Exercise 06.4: five drills on targets close to a curve.
#include "chapters/exercise.hpp"

#include <cmath>
#include <complex>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;

// Task 1: rule minus integral for the pole tau, with n nodes.
Complex pole_error(Complex tau, int n) {
  //@ starter
  not_done(tau, n);  // your code instead of this line
  //@ solution
  const Complex q = std::exp(imaginary * static_cast<double>(n) * tau);
  return (tau.imag() > 0.0 ? q : 1.0) / (1.0 - q);
  //@ wrong always_above: below the real axis the integral is -1/2
  const Complex q = std::exp(imaginary * static_cast<double>(n) * tau);
  return q / (1.0 - q);
  //@ wrong no_phase: this is right for a target next to a node
  const double q = std::exp(-n * std::abs(tau.imag()));
  return tau.imag() > 0.0 ? q / (1.0 - q) : -q / (1.0 - q);
  //@ end
}

// Task 2: the velocity from Goursat's functions.
Complex velocity(Complex z, Complex phi, Complex dphi, Complex psi) {
  //@ starter
  not_done(z, phi, dphi, psi);  // your code instead of this line
  //@ solution
  return phi - z * std::conj(dphi) - std::conj(psi);
  //@ wrong psi_not_conjugate: psi must be conjugate
  return phi - z * std::conj(dphi) - psi;
  //@ wrong conjugate_point: z itself stands in front
  return phi - std::conj(z) * dphi - std::conj(psi);
  //@ wrong plus: the signs of the last two terms are the other ones
  return phi + z * std::conj(dphi) + std::conj(psi);
  //@ end
}

// Task 3: df/dx along the curve, from df/dt and dx/dt.
Complex along_curve(Complex df, Complex dx) {
  //@ starter
  not_done(df, dx);  // your code instead of this line
  //@ solution
  return df / dx;
  //@ wrong per_length: this is the derivative with respect to the arclength
  return df / std::abs(dx);
  //@ wrong conjugate: this divides by the conjugate
  return df / std::conj(dx);
  //@ end
}

// Task 4: the side test, from the sum of all W_j at a target.
bool in_the_fluid(Complex sum, Side side) {
  //@ starter
  not_done(sum, side);  // your code instead of this line
  //@ solution
  return sum.real() + (side == Side::fluid_outside ? 1.0 : 0.0) > 0.5;
  //@ wrong without_one: the 1 of a body is missing
  static_cast<void>(side);
  return sum.real() > 0.5;
  //@ wrong modulus: this takes the modulus
  return std::abs(sum + (side == Side::fluid_outside ? 1.0 : 0.0)) > 0.5;
  //@ wrong one_for_all: the sum of a wall needs no 1
  static_cast<void>(side);
  return sum.real() + 1.0 > 0.5;
  //@ end
}

// Task 5: the depth of the singularities for two equal circles.
double gap_depth(double gap, double radius) {
  //@ starter
  not_done(gap, radius);  // your code instead of this line
  //@ solution
  return 2.0 * std::asinh(std::sqrt(gap / (4.0 * radius)));
  //@ wrong cancelled: the sum rounds off digits of the gap
  return std::acosh(1.0 + gap / (2.0 * radius));
  //@ wrong small_gaps: this holds for small gaps only
  return std::sqrt(gap / radius);
  //@ wrong unit_circles: this is the depth for circles of radius 1
  static_cast<void>(radius);
  return 2.0 * std::asinh(std::sqrt(gap / 4.0));
  //@ end
}
