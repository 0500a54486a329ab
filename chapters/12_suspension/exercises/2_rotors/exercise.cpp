// Exercise 12.2: rotors that carry each other round.
#include "chapters/exercise.hpp"

#include <cmath>
#include <complex>
#include <numbers>

using Complex = std::complex<double>;  // x + i y
using stokesbook::exercise::not_done;
using std::numbers::pi;

// Task 1: the velocity at x around a point at the origin with the torque L.
Complex rotlet(Complex x, double torque, double mu) {
  //@ starter
  not_done(x, torque, mu);  // your code instead of this line
  //@ solution
  return Complex{0.0, torque / (4.0 * pi * mu)} * x / std::norm(x);
  //@ wrong vortex: a point vortex has its circulation there
  return Complex{0.0, torque / (2.0 * pi * mu)} * x / std::norm(x);
  //@ wrong clockwise: a positive torque turns counter-clockwise
  return Complex{0.0, -torque / (4.0 * pi * mu)} * x / std::norm(x);
  //@ end
}

// Task 2: the speed of n rotlets on a ring of radius R.
double ring_speed(int n, double radius, double torque, double mu) {
  //@ starter
  not_done(n, radius, torque, mu);  // your code instead of this line
  //@ solution
  return (n - 1) * torque / (8.0 * pi * mu * radius);
  //@ wrong itself: nobody carries himself
  return n * torque / (8.0 * pi * mu * radius);
  //@ wrong straight: only the part along the ring
  double speed = 0.0;
  for (int k = 1; k < n; ++k) speed += torque / (8.0 * pi * mu * radius * std::sin(pi * k / n));
  return speed;
  //@ end
}

// Task 3: the angular velocity of each disk of radius a, far from the others.
double turn(int n, double a, double radius, double torque, double mu) {
  //@ starter
  not_done(n, a, radius, torque, mu);  // your code instead of this line
  //@ solution
  (void)n, (void)radius;
  return torque / (4.0 * pi * mu * a * a);
  //@ wrong carried: bodies that are carried round need not turn
  return torque / (4.0 * pi * mu * a * a) + (n - 1) * torque / (8.0 * pi * mu * radius * radius);
  //@ end
}

// Task 4: the difference of the speed from that of rotlets is C (a/R)^p of it.
int order() {
  //@ starter
  not_done();  // your code instead of this line
  //@ solution
  return 2;
  //@ wrong strain: strains of rotlets call stresslets
  return 1;
  //@ wrong higher: stresslets fall like
  return 4;
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
