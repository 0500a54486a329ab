// Exercise 12.1: balances of torque and power.
#include "chapters/exercise.hpp"

#include <complex>
#include <numbers>

#include <Eigen/Core>

using Complex = std::complex<double>;  // x + i y
using Eigen::VectorXcd;
using Eigen::VectorXd;
using stokesbook::exercise::not_done;
using std::numbers::pi;

// Task 1: the torque about the origin of a force and a torque that act about a position.
double torque_about_origin(Complex force, double torque, Complex position) {
  //@ starter
  not_done(force, torque, position);  // your code instead of this line
  //@ solution
  return torque + position.real() * force.imag() - position.imag() * force.real();
  //@ wrong free_vector: a force has a torque about other points
  (void)force, (void)position;
  return torque;
  //@ wrong other_order: position cross force
  return torque - position.real() * force.imag() + position.imag() * force.real();
  //@ end
}

// Task 2: the power that all components put into the fluid.
double power(const VectorXcd& forces, const VectorXd& torques, const VectorXcd& velocities,
             const VectorXd& omegas) {
  //@ starter
  not_done(forces, torques, velocities, omegas);  // your code instead of this line
  //@ solution
  return (forces.array().conjugate() * velocities.array()).real().sum() + torques.dot(omegas);
  //@ wrong no_rotation: torques turn things
  (void)torques, (void)omegas;
  return (forces.array().conjugate() * velocities.array()).real().sum();
  //@ wrong no_conjugate: the scalar product of the plane
  return (forces.array() * velocities.array()).real().sum() + torques.dot(omegas);
  //@ end
}

// Task 3: by the inner cylinder, at rest, on the fluid, while the outer one turns at omega.
double empty_torque(double mu, double omega, double r_inner, double r_outer) {
  //@ starter
  not_done(mu, omega, r_inner, r_outer);  // your code instead of this line
  //@ solution
  const double a2 = r_inner * r_inner, b2 = r_outer * r_outer;
  return -4.0 * pi * mu * omega * a2 * b2 / (b2 - a2);
  //@ wrong sign: the inner cylinder holds the fluid back
  const double a2 = r_inner * r_inner, b2 = r_outer * r_outer;
  return 4.0 * pi * mu * omega * a2 * b2 / (b2 - a2);
  //@ wrong half: 4 pi mu B
  const double a2 = r_inner * r_inner, b2 = r_outer * r_outer;
  return -2.0 * pi * mu * omega * a2 * b2 / (b2 - a2);
  //@ end
}

// Task 4: the effective viscosity over mu, where bodies are free and the outer cylinder turns.
double viscosity_by_power(double power, double mu, double omega, double r_inner, double r_outer) {
  //@ starter
  not_done(power, mu, omega, r_inner, r_outer);  // your code instead of this line
  //@ solution
  return power / (-omega * empty_torque(mu, omega, r_inner, r_outer));
  //@ wrong torque: a power, not a torque
  return power / -empty_torque(mu, omega, r_inner, r_outer);
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
