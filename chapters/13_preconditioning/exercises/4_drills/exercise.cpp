// Exercise 13.4: five drills on spectra, pores and clusters.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Core>

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
using stokesbook::exercise::not_done;

// Task 1: by how much the logarithm of the distance from 1 falls from eigenvalue to eigenvalue.
double distance_rate(double gap) {
  //@ starter
  not_done(gap);  // your code instead of this line
  //@ solution
  return std::acosh(1.0 + 0.5 * gap) / 4.0;
  //@ wrong from_mode_to_mode: a mode has eight eigenvalues
  return 2.0 * std::acosh(1.0 + 0.5 * gap);
  //@ wrong four_of_a_mode: a sine as well as a cosine
  return std::acosh(1.0 + 0.5 * gap) / 2.0;
  //@ end
}

// Task 2: the pressure that drives a flux through the gap of two disks.
double pore_pressure(double viscosity, double flux, double gap, double radius) {
  //@ starter
  not_done(viscosity, flux, gap, radius);  // your code instead of this line
  //@ solution
  return 4.5 * pi * viscosity * flux * std::sqrt(radius) * std::pow(gap, -2.5);
  //@ wrong pair: the power of a pair that approaches
  return 4.5 * pi * viscosity * flux * std::sqrt(radius) * std::pow(gap, -1.5);
  //@ wrong one_side: both sides of the narrowest place
  return 2.25 * pi * viscosity * flux * std::sqrt(radius) * std::pow(gap, -2.5);
  //@ wrong no_length: the substitution changes dx
  (void)radius;
  return 4.5 * pi * viscosity * flux * std::pow(gap, -3.0);
  //@ end
}

// Task 3: the solution for a free body, from the inverse for a held one.
VectorXd released(const MatrixXd& held_inverse, const VectorXd& K, const VectorXd& Pi,
                  const VectorXd& r) {
  //@ starter
  not_done(held_inverse, K, Pi, r);  // your code instead of this line
  //@ solution
  const double V = Pi.dot(held_inverse * r) / Pi.dot(held_inverse * K);
  return held_inverse * (r - V * K) - V * K;
  //@ wrong plus: the density of a motion is minus the motion
  const double V = Pi.dot(held_inverse * r) / Pi.dot(held_inverse * K);
  return held_inverse * (r - V * K) + V * K;
  //@ wrong data_kept: subtract the motions from the data
  const double V = Pi.dot(held_inverse * r) / Pi.dot(held_inverse * K);
  return held_inverse * r - V * K;
  //@ end
}

// Task 4: the product of the inverse of 1 + beta q q^T with x.
VectorXd compressed(const VectorXd& q, double beta, const VectorXd& x) {
  //@ starter
  not_done(q, beta, x);  // your code instead of this line
  //@ solution
  const double along = q.dot(x);
  return x - along * q + along / (1.0 + beta) * q;
  //@ wrong rest_dropped: is unchanged, and not zero
  return q.dot(x) / (1.0 + beta) * q;
  //@ wrong first_order: the first term of the series
  return x - beta * q.dot(x) * q;
  //@ wrong added: the part along q is in x already
  return x + q.dot(x) / (1.0 + beta) * q;
  //@ end
}

// Task 5: the sum of all forces between two radii.
double forces_left_out(double density, double inner, double outer) {
  //@ starter
  not_done(density, inner, outer);  // your code instead of this line
  //@ solution
  return 2.0 * pi * density * std::log(outer / inner);
  //@ wrong equal_rings: wide rings have more disks
  return 2.0 * pi * density * (1.0 / inner - 1.0 / outer);
  //@ wrong no_circle: the circumference is 2 pi rho
  return density * std::log(outer / inner);
  //@ end
}
