// Exercise 12.3: the force between two disks.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <complex>

#include <Eigen/Core>

using Complex = std::complex<double>;  // x + i y
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// Task 1: how the gap between disks about a and b changes with x, y and the angle of both.
VectorXd gap_gradient(Complex a, Complex b) {
  //@ starter
  not_done(a, b);  // your code instead of this line
  //@ solution
  const Complex n = (b - a) / std::abs(b - a);
  return VectorXd{{-n.real(), -n.imag(), 0.0, n.real(), n.imag(), 0.0}};
  //@ wrong other_sign: the gap opens as b moves away
  const Complex n = (b - a) / std::abs(b - a);
  return VectorXd{{n.real(), n.imag(), 0.0, -n.real(), -n.imag(), 0.0}};
  //@ wrong not_normal: a unit vector
  const Complex n = b - a;
  return VectorXd{{-n.real(), -n.imag(), 0.0, n.real(), n.imag(), 0.0}};
  //@ end
}

// Task 2: the least force that leaves the separation at the end of the step.
double contact_force(double gap, double separation, double dt, double free_rate, double response) {
  //@ starter
  not_done(gap, separation, dt, free_rate, response);  // your code instead of this line
  //@ solution
  return std::max(0.0, -(gap - separation + dt * free_rate) / (dt * response));
  //@ wrong pulls: forces only push
  return -(gap - separation + dt * free_rate) / (dt * response);
  //@ wrong stops: a gap may close as far as the separation
  (void)gap, (void)separation, (void)dt;
  return std::max(0.0, -free_rate / response);
  //@ end
}

// Task 3: what the disks do under a force along the gap.
VectorXd velocities(const VectorXd& free, const VectorXd& by_unit_force, double force) {
  //@ starter
  not_done(free, by_unit_force, force);  // your code instead of this line
  //@ solution
  return free + force * by_unit_force;
  //@ wrong instead: in addition to what they do
  (void)free;
  return force * by_unit_force;
  //@ end
}

// Task 4: of the force on both disks, in a step at whose end the gap is the separation.
double contact_power(double gap, double separation, double dt, double force) {
  //@ starter
  not_done(gap, separation, dt, force);  // your code instead of this line
  //@ solution
  return -force * (gap - separation) / dt;
  //@ wrong gains: contact takes energy
  return force * (gap - separation) / dt;
  //@ wrong work: a work, not a power
  (void)dt;
  return -force * (gap - separation);
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
