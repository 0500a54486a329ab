// Exercise 01.4: five drills on curves and on the trapezoid rule.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: the unit normal out of the fluid.
Complex normal(Complex dx, Side side) {
  //@ starter
  not_done(dx, side);  // your code instead of this line
  //@ solution
  const Complex outward = -imaginary * dx / std::abs(dx);
  return side == Side::fluid_inside ? outward : -outward;
  //@ wrong into_the_fluid: this normal points into the fluid
  const Complex outward = -imaginary * dx / std::abs(dx);
  return side == Side::fluid_inside ? -outward : outward;
  //@ wrong out_of_the_curve: this normal points out of the curve
  static_cast<void>(side);
  return -imaginary * dx / std::abs(dx);
  //@ end
}

// Task 2: the curvature, positive where the curve is convex.
double curvature(Complex dx, Complex ddx) {
  //@ starter
  not_done(dx, ddx);  // your code instead of this line
  //@ solution
  return cross(dx, ddx) / std::pow(std::abs(dx), 3);
  //@ wrong per_parameter: this is the turn of the tangent per unit of t
  return cross(dx, ddx) / std::norm(dx);
  //@ wrong second_derivative: this is right if t is the arclength
  return std::abs(ddx) / std::norm(dx);
  //@ end
}

// Task 3: the integral over a period, from N + 1 values; the last one repeats the first one.
double integral(const Eigen::VectorXd& values) {
  //@ starter
  not_done(values);  // your code instead of this line
  //@ solution
  return 2.0 * pi * values.head(values.size() - 1).mean();
  //@ wrong counted_twice: the first node counts twice
  return 2.0 * pi / static_cast<double>(values.size() - 1) * values.sum();
  //@ wrong one_node_more: the mean contains the first node twice
  return 2.0 * pi * values.mean();
  //@ end
}

// Task 4: the wave number from -n/2 to n/2 - 1 that n nodes cannot tell from k; n is even.
int wave_number(int k, int n) {
  //@ starter
  not_done(k, n);  // your code instead of this line
  //@ solution
  const int from_zero = ((k + n / 2) % n + n) % n;
  return from_zero - n / 2;
  //@ wrong from_zero: these wave numbers run from 0 to N - 1
  return (k % n + n) % n;
  //@ wrong negative_remainder: the remainder of a negative number is negative
  return (k + n / 2) % n - n / 2;
  //@ end
}

// Task 5: the rate of the perimeter of an ellipse.
double perimeter_rate(double a, double b) {
  //@ starter
  not_done(a, b);  // your code instead of this line
  //@ solution
  return std::atanh(std::min(a, b) / std::max(a, b));
  //@ wrong slender: this holds for slender ellipses only
  return std::min(a, b) / std::max(a, b);
  //@ wrong kernel: this is the rate of the kernel
  return 2.0 * std::atanh(std::min(a, b) / std::max(a, b));
  //@ end
}
