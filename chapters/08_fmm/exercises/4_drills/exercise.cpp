// Exercise 08.4: five drills on expansions and boxes.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

using Complex = std::complex<double>;  // x + i y
using stokesbook::exercise::not_done;

// Task 1: what p terms about c leave out, as a part of 1/(z - y).
Complex part_left_out(Complex z, Complex y, Complex c, int p) {
  //@ starter
  not_done(z, y, c, p);  // your code instead of this line
  //@ solution
  return std::pow((y - c) / (z - c), p);
  //@ wrong next_power: the first power of q that is left out is p
  return std::pow((y - c) / (z - c), p + 1);
  //@ wrong from_the_source: the distance of the target from the source
  return std::pow((y - c) / (z - y), p);
  //@ end
}

// Task 2: psi of a new centre at a point, from psi of the old one and the derivative of phi.
Complex psi_about(Complex new_centre, Complex old_centre, Complex psi, Complex phi_prime) {
  //@ starter
  not_done(new_centre, old_centre, psi, phi_prime);  // your code instead of this line
  //@ solution
  return psi + std::conj(new_centre - old_centre) * phi_prime;
  //@ wrong other_way: this moves the centre the other way
  return psi - std::conj(new_centre - old_centre) * phi_prime;
  //@ wrong not_conjugate: the difference of the centres is conjugate here
  return psi + (new_centre - old_centre) * phi_prime;
  //@ end
}

// Task 3: the distance of the centres beyond which two boxes are well separated.
double least_distance(double source_radius, double target_radius, double rho) {
  //@ starter
  not_done(source_radius, target_radius, rho);  // your code instead of this line
  //@ solution
  return std::max(source_radius / rho + target_radius, target_radius / rho + source_radius);
  //@ wrong one_condition: the local expansion has a condition too
  return source_radius / rho + target_radius;
  //@ wrong from_centres: distance of the two centres
  return std::max(source_radius, target_radius) / rho;
  //@ end
}

// Task 4: the coefficient of x^l in (D + x)^-k.
Complex shifted_coefficient(Complex D, int k, int l) {
  //@ starter
  not_done(D, k, l);  // your code instead of this line
  //@ solution
  Complex coefficient = std::pow(D, -k);
  for (int i = 1; i <= l; ++i) coefficient *= -(k + i - 1.0) / i / D;
  return coefficient;
  //@ wrong no_sign: each derivative of a negative power changes the sign
  Complex coefficient = std::pow(D, -k);
  for (int i = 1; i <= l; ++i) coefficient *= (k + i - 1.0) / i / D;
  return coefficient;
  //@ wrong positive_power: the coefficients of the power k
  Complex coefficient = std::pow(D, -k);
  for (int i = 1; i <= l; ++i) coefficient *= (k - i + 1.0) / i / D;
  return coefficient;
  //@ end
}

// Task 5: the number of boxes with the least operations on one level.
double best_boxes(double nodes, double order) {
  //@ starter
  not_done(nodes, order);  // your code instead of this line
  //@ solution
  return std::cbrt(13.0 * nodes * nodes / (order * order));
  //@ wrong equal_terms: here the two terms are equal
  return std::cbrt(26.0 * nodes * nodes / (order * order));
  //@ wrong forgotten_half: derivative of beta^2/2
  return std::cbrt(13.0 * nodes * nodes / (2.0 * order * order));
  //@ end
}
