// Exercise 10.4: five drills on gaps and contacts.
#include "chapters/exercise.hpp"

#include <cmath>
#include <complex>

#include <Eigen/Core>

using Complex = std::complex<double>;  // x + i y
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// Task 1: the largest distance between a circle and an edge of a polygon within it.
double sag(double radius, double edge) {
  //@ starter
  not_done(radius, edge);  // your code instead of this line
  //@ solution
  return radius - std::sqrt(radius * radius - 0.25 * edge * edge);
  //@ wrong whole_edge: half of the edge
  return radius - std::sqrt(radius * radius - edge * edge);
  //@ wrong expanded: this is the leading term
  return edge * edge / (8.0 * radius);
  //@ end
}

// Task 2: the place of the point x of A in the frame of B.
Complex seen_from_b(Complex centre_a, double angle_a, Complex centre_b, double angle_b, Complex x) {
  //@ starter
  not_done(centre_a, angle_a, centre_b, angle_b, x);  // your code instead of this line
  //@ solution
  return std::polar(1.0, -angle_b) * (centre_a - centre_b) + std::polar(1.0, angle_a - angle_b) * x;
  //@ wrong turned_forward: the frame of B is turned back by its angle
  return std::polar(1.0, angle_b) * (centre_a - centre_b) + std::polar(1.0, angle_a + angle_b) * x;
  //@ wrong centres_not_turned: the difference of the centres is turned as well
  return centre_a - centre_b + std::polar(1.0, angle_a - angle_b) * x;
  //@ end
}

// Task 3: the first time at which the gap of two circles is the separation.
double contact_time(Complex offset, Complex drift, double radius, double separation) {
  //@ starter
  not_done(offset, drift, radius, separation);  // your code instead of this line
  //@ solution
  const double reach = 2.0 * radius + separation, a = std::norm(drift);
  const double b = (std::conj(offset) * drift).real(), c = std::norm(offset) - reach * reach;
  return (-b - std::sqrt(b * b - a * c)) / a;
  //@ wrong last_time: when they part again
  const double reach = 2.0 * radius + separation, a = std::norm(drift);
  const double b = (std::conj(offset) * drift).real(), c = std::norm(offset) - reach * reach;
  return (-b + std::sqrt(b * b - a * c)) / a;
  //@ wrong touching: this is the time at which they touch
  (void)separation;
  const double reach = 2.0 * radius, a = std::norm(drift);
  const double b = (std::conj(offset) * drift).real(), c = std::norm(offset) - reach * reach;
  return (-b - std::sqrt(b * b - a * c)) / a;
  //@ end
}

// Task 4: the part of the distance from a wall that one step of the search leaves.
double left_by_step(double angle) {
  //@ starter
  not_done(angle);  // your code instead of this line
  //@ solution
  return 1.0 - std::cos(angle);
  //@ wrong gained: the part by which the step comes nearer
  return std::cos(angle);
  //@ wrong from_the_wall: measured from the normal
  return 1.0 - std::sin(angle);
  //@ end
}

// Task 5: the derivative of the gap with respect to x, y and angle of A, then of B.
VectorXd row(Complex normal, Complex arm_a, Complex arm_b) {
  //@ starter
  not_done(normal, arm_a, arm_b);  // your code instead of this line
  //@ solution
  const double turn_a = (std::conj(arm_a) * normal).imag();
  const double turn_b = (std::conj(arm_b) * normal).imag();
  return VectorXd{{normal.real(), normal.imag(), turn_a, -normal.real(), -normal.imag(), -turn_b}};
  //@ wrong torque_of_b: the torque on B has a minus sign too
  const double turn_a = (std::conj(arm_a) * normal).imag();
  const double turn_b = (std::conj(arm_b) * normal).imag();
  return VectorXd{{normal.real(), normal.imag(), turn_a, -normal.real(), -normal.imag(), turn_b}};
  //@ wrong crossed: arm x normal
  const double turn_a = (std::conj(normal) * arm_a).imag();
  const double turn_b = (std::conj(normal) * arm_b).imag();
  return VectorXd{{normal.real(), normal.imag(), turn_a, -normal.real(), -normal.imag(), -turn_b}};
  //@ end
}
