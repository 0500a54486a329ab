// Exercise 07.2: the intrinsic viscosity of ellipses that tumble, and of ellipses at random.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "trapezoid/plane.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Given: S_11 + i S_12 of a free ellipse with semi-axes r and 1 in the flow (y, 0).
Complex stresslet(double aspect, double angle);

// Task 1: [mu] at an angle; q = i, viscosity 1.
double intrinsic(double aspect, double angle) {
  //@ starter
  not_done(aspect, angle);  // your code instead of this line
  //@ solution
  return stresslet(aspect, angle).imag() / (pi * aspect);
  //@ wrong unit_area: the area of the ellipse is missing
  return stresslet(aspect, angle).imag() / pi;
  //@ wrong normal_stress: the shear stress is S12
  return stresslet(aspect, angle).real() / (pi * aspect);
  //@ end
}

// Task 2: the angle at a phase of the orbit.
double orbit_angle(double aspect, double phase) {
  //@ starter
  not_done(aspect, phase);  // your code instead of this line
  //@ solution
  return std::atan2(-std::sin(phase), aspect * std::cos(phase));
  //@ wrong counter_clockwise: the flow (y, 0) turns it clockwise
  return std::atan2(std::sin(phase), aspect * std::cos(phase));
  //@ wrong minor_axis: the ellipse is slow along the flow
  return std::atan2(-aspect * std::sin(phase), std::cos(phase));
  //@ end
}

// Task 3: mean over M equal times of half an orbit.
double orbit_mean(double aspect, int instants) {
  //@ starter
  not_done(aspect, instants);  // your code instead of this line
  //@ solution
  double sum = 0.0;
  for (int j = 0; j < instants; ++j) {
    sum += intrinsic(aspect, orbit_angle(aspect, pi * j / instants));
  }
  return sum / instants;
  //@ wrong equal_angles: the ellipse does not turn evenly
  double sum = 0.0;
  for (int j = 0; j < instants; ++j) sum += intrinsic(aspect, pi * j / instants);
  return sum / instants;
  //@ wrong both_ends: the last instant is the first one again
  double sum = 0.0;
  for (int j = 0; j <= instants; ++j) {
    sum += intrinsic(aspect, orbit_angle(aspect, pi * j / instants));
  }
  return sum / (instants + 1);
  //@ end
}

// Task 4: mean over all angles, equally likely.
double random_mean(double aspect) {
  //@ starter
  not_done(aspect);  // your code instead of this line
  //@ solution
  const double sum = aspect + 1.0, squares = aspect * aspect + 1.0;
  return sum * sum / (4.0 * aspect) * (1.0 + 2.0 * aspect / squares);
  //@ wrong two: this is the mean over an orbit
  static_cast<void>(aspect);
  return 2.0;
  //@ wrong no_half: the mean of a squared sine is one half
  const double sum = aspect + 1.0, squares = aspect * aspect + 1.0;
  return sum * sum / (2.0 * aspect) * (1.0 + 2.0 * aspect / squares);
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
