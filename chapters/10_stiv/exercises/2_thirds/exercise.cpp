// Exercise 10.2: the rate of Newton's method for volumes.
#include "chapters/exercise.hpp"

#include <cmath>
#include <functional>

#include <Eigen/Core>

using Eigen::VectorXd;
using stokesbook::exercise::not_done;

using Function = std::function<double(double)>;

// Task 1: V < 0 of one side, circles of radius a that keep a separation, at a small depth.
double volume(double a, double separation, double depth) {
  //@ starter
  not_done(a, separation, depth);  // your code instead of this line
  //@ solution
  const double k = 0.5 * (1.0 / a + 1.0 / (a + separation));
  return -4.0 / 3.0 * std::pow(depth, 1.5) / std::sqrt(k);
  //@ wrong thin: the separation's own curvature is missing
  static_cast<void>(separation);
  return -4.0 / 3.0 * std::sqrt(a) * std::pow(depth, 1.5);
  //@ wrong half: this is one half of one side
  const double k = 0.5 * (1.0 / a + 1.0 / (a + separation));
  return -2.0 / 3.0 * std::pow(depth, 1.5) / std::sqrt(k);
  //@ end
}

// Task 2: the part of p that an iteration leaves for V = -C p^q.
double left_by_newton(double q) {
  //@ starter
  not_done(q);  // your code instead of this line
  //@ solution
  return 1.0 - 1.0 / q;
  //@ wrong taken: this is the part that is taken away
  return 1.0 / q;
  //@ end
}

// Task 3: iterations from a depth to a tolerance, not rounded.
double iterations_needed(double depth, double tolerance, double q) {
  //@ starter
  not_done(depth, tolerance, q);  // your code instead of this line
  //@ solution
  return std::log(tolerance / depth) / std::log(1.0 - 1.0 / q);
  //@ wrong quadratic: digits do not double here
  return std::log2(std::log(tolerance) / std::log(depth)) + 0.0 * q;
  //@ end
}

// Task 4: the start, then the places after each of the iterations.
VectorXd newton(const Function& v, const Function& slope, double start, int count) {
  //@ starter
  not_done(v, slope, start, count);  // your code instead of this line
  //@ solution
  VectorXd places(count + 1);
  places[0] = start;
  for (int k = 0; k < count; ++k) places[k + 1] = places[k] - v(places[k]) / slope(places[k]);
  return places;
  //@ wrong frozen: the slope has to be that of the latest place
  VectorXd places(count + 1);
  places[0] = start;
  for (int k = 0; k < count; ++k) places[k + 1] = places[k] - v(places[k]) / slope(start);
  return places;
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
