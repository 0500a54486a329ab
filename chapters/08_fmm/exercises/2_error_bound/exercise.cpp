// Exercise 08.2: the order that a tolerance needs.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using stokesbook::exercise::not_done;

// Task 1: the ratio of two disks.
double ratio(double source_radius, double target_radius, double distance) {
  //@ starter
  not_done(source_radius, target_radius, distance);  // your code instead of this line
  //@ solution
  return std::max(source_radius / (distance - target_radius),
                  target_radius / (distance - source_radius));
  //@ wrong centres: targets are nearer than the centre of their disk
  return std::max(source_radius, target_radius) / distance;
  //@ wrong multipole_only: the local expansion has a ratio too
  return source_radius / (distance - target_radius);
  //@ end
}

// Task 2: the least p >= 1 with p rho^p <= tolerance.
int order_needed(double rho, double tolerance) {
  //@ starter
  not_done(rho, tolerance);  // your code instead of this line
  //@ solution
  int p = 1;
  while (p * std::pow(rho, p) > tolerance) ++p;
  return p;
  //@ wrong without_factor: the factor p is missing
  return static_cast<int>(std::ceil(std::log(tolerance) / std::log(rho)));
  //@ wrong one_less: the bound is not met yet
  int p = 1;
  while (p * std::pow(rho, p) > tolerance) ++p;
  return p - 1;
  //@ end
}

// Task 3: work of the translations, 1 for rho = 1/2.
double work(double rho) {
  //@ starter
  not_done(rho);  // your code instead of this line
  //@ solution
  const double order = std::numbers::ln2 / std::log(1.0 / rho);  // relative
  return order * order / (4.0 * rho * rho);
  //@ wrong linear: a conversion takes p^2 operations
  return std::numbers::ln2 / std::log(1.0 / rho) / (4.0 * rho * rho);
  //@ wrong same_lists: lists grow as boxes have to be farther apart
  const double order = std::numbers::ln2 / std::log(1.0 / rho);
  return order * order;
  //@ end
}

// Task 4: the rho of least work.
double best_ratio() {
  //@ starter
  not_done();  // your code instead of this line
  //@ solution
  return 1.0 / std::numbers::e;
  //@ wrong library: this is the ratio of the library
  return 0.5;
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
