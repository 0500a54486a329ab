// Exercise 12.4: five drills on flows, gaps and steps.
#include "chapters/exercise.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Core>

using Eigen::Matrix2d;
using stokesbook::exercise::not_done;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Task 1: the angular velocity of the rigid part of the flow u(c) + G d.
double background_turn(const Matrix2d& G) {
  //@ starter
  not_done(G);  // your code instead of this line
  //@ solution
  return 0.5 * (G(1, 0) - G(0, 1));
  //@ wrong vorticity: half of it
  return G(1, 0) - G(0, 1);
  //@ wrong clockwise: counter-clockwise
  return 0.5 * (G(0, 1) - G(1, 0));
  //@ end
}

// Task 2: the rate at which Fourier modes fall, for two circles with a gap.
double decay_rate(double gap, double radius) {
  //@ starter
  not_done(gap, radius);  // your code instead of this line
  //@ solution
  return std::acosh(1.0 + 0.5 * gap / radius);
  //@ wrong whole_gap: half of the distance contains half of the gap
  return std::acosh(1.0 + gap / radius);
  //@ wrong no_radius: a rate has no unit
  (void)radius;
  return std::acosh(1.0 + 0.5 * gap);
  //@ wrong narrow: the limit for narrow gaps
  return std::sqrt(gap / radius);
  //@ end
}

// Task 3: the gap after a time, which falls at the rate c gap^(3/2).
double gap_after(double start, double c, double time) {
  //@ starter
  not_done(start, c, time);  // your code instead of this line
  //@ solution
  return std::pow(1.0 / std::sqrt(start) + 0.5 * c * time, -2.0);
  //@ wrong opens: this gap becomes wider
  return std::pow(1.0 / std::sqrt(start) - 0.5 * c * time, -2.0);
  //@ wrong no_half: the integral of the power -3/2
  return std::pow(1.0 / std::sqrt(start) + c * time, -2.0);
  //@ wrong constant_rate: the rate at the start
  return start - c * std::pow(start, 1.5) * time;
  //@ end
}

// Task 4: the gap at which some digits of a velocity are left.
double least_gap(double digits) {
  //@ starter
  not_done(digits, epsilon);  // your code instead of this line
  //@ solution
  return std::pow(epsilon * std::pow(10.0, digits), 2.0 / 3.0);
  //@ wrong other_power: solve for the gap
  return std::pow(epsilon * std::pow(10.0, digits), 1.5);
  //@ wrong lost: digits that are lost
  return std::pow(10.0, -digits * 2.0 / 3.0);
  //@ end
}

// Task 5: how much farther from the axis a point is after a step of Heun's method.
double heun_drift(double radius, double theta) {
  //@ starter
  not_done(radius, theta);  // your code instead of this line
  //@ solution
  return radius * (std::hypot(1.0 - 0.5 * theta * theta, theta) - 1.0);
  //@ wrong euler: the drift of Euler's method
  return radius * (std::hypot(1.0, theta) - 1.0);
  //@ wrong square: the square of the factor
  return radius * (0.25 * std::pow(theta, 4.0));
  //@ wrong whole_square: second term of Heun's factor
  return radius * (std::hypot(1.0 - theta * theta, theta) - 1.0);
  //@ end
}
