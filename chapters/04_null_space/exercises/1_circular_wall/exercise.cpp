// Exercise 04.1: everything about N_0 on a circular wall.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: for translations, the rotation, the normal, and all else.
std::array<double, 4> eigenvalues(double radius, double factor) {
  //@ starter
  not_done(radius, factor);  // your code instead of this line
  //@ solution
  return {-1.0, -1.0, 2.0 * pi * radius * factor, -0.5};
  //@ wrong body: this is the circle of a body
  return {0.0, 0.0, -1.0 + 2.0 * pi * radius * factor, -0.5};
  //@ wrong no_length: the integral of n.n is missing
  static_cast<void>(radius);
  return {-1.0, -1.0, factor, -0.5};
  //@ end
}

// Task 2: largest singular value over the least one.
double condition(double radius, double factor) {
  //@ starter
  not_done(radius, factor);  // your code instead of this line
  //@ solution
  const double moved = std::abs(2.0 * pi * radius * factor);
  return std::max(1.0, moved) / std::min(0.5, moved);
  //@ wrong large_only: this holds for large factors only
  return 2.0 * std::abs(2.0 * pi * radius * factor);
  //@ wrong signed: singular values have no sign
  const double moved = 2.0 * pi * radius * factor;
  return std::max(1.0, moved) / std::min(0.5, moved);
  //@ end
}

// Task 3: the largest factor with a condition number of at most the bound.
double largest_factor(double radius, double bound) {
  //@ starter
  not_done(radius, bound);  // your code instead of this line
  //@ solution
  return bound / (4.0 * pi * radius);
  //@ wrong least_is_one: the least singular value is 1/2
  return bound / (2.0 * pi * radius);
  //@ wrong least_factor: this is the least one
  return 1.0 / (bound * 2.0 * pi * radius);
  //@ wrong small_root: this is near the least one
  return 0.5 / (bound * 2.0 * pi * radius);
  //@ end
}

// Task 4: the density of a circular wall that belongs to a boundary velocity, with N_0.
ComplexVector density(const Curve& wall, const ComplexVector& velocity) {
  //@ starter
  not_done(wall, velocity);  // your code instead of this line
  //@ solution
  const ComplexVector normal = normals(wall);
  const Complex mean = velocity.mean(),
                first = normal.dot(velocity) / static_cast<double>(wall.size());
  return (-2.0 * velocity + first * normal).array() + mean;
  //@ wrong jump_only: this inverts the jump alone
  static_cast<void>(wall);
  return -2.0 * velocity;
  //@ wrong normal_only: the rotation has the eigenvalue -1 too
  const ComplexVector normal = normals(wall);
  const Complex mean = velocity.mean(),
                first = normal.dot(velocity) / static_cast<double>(wall.size());
  return (-2.0 * velocity + first.real() * normal).array() + mean;
  //@ end
}

// Task 5: the density of an elliptic wall, at its nodes, that belongs to the velocity (x, -y).
ComplexVector stretched(const Ellipse& ellipse, const Curve& wall) {
  //@ starter
  not_done(ellipse, wall);  // your code instead of this line
  //@ solution
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  return -2.0 / (1.0 + m * m) * wall.x.conjugate();
  //@ wrong circle: this is right on a circle
  static_cast<void>(ellipse);
  return -2.0 * wall.x.conjugate();
  //@ wrong with_flux: this makes the right flow, but has a flux
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  return -2.0 / (1.0 - m * m) * (wall.x.conjugate() - m * wall.x);
  //@ end
}
