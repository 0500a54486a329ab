// Exercise 01.3: what a corner does to the trapezoid rule on [0, 2 pi], and its repair.
#include "chapters/exercise.hpp"

#include <cmath>
#include <functional>
#include <numbers>

using std::numbers::pi;
using stokesbook::exercise::not_done;

using Function = std::function<double(double)>;

// Task 1: the rule with n intervals, for a function that need not be periodic.
double trapezoid(const Function& f, int n) {
  //@ starter
  not_done(f, n);  // your code instead of this line
  //@ solution
  const double h = 2.0 * pi / n;
  double sum = 0.5 * (f(0.0) + f(2.0 * pi));
  for (int j = 1; j < n; ++j) sum += f(j * h);
  return h * sum;
  //@ wrong ends_in_full: both ends count in full here
  const double h = 2.0 * pi / n;
  double sum = 0.0;
  for (int j = 0; j <= n; ++j) sum += f(j * h);
  return h * sum;
  //@ wrong left_end_only: this leaves out the end 2 pi
  const double h = 2.0 * pi / n;
  double sum = 0.0;
  for (int j = 0; j < n; ++j) sum += f(j * h);
  return h * sum;
  //@ end
}

// Task 2: leading term of rule minus integral, from the slopes of f at 0 and 2 pi.
double end_error(double slope_start, double slope_end, int n) {
  //@ starter
  not_done(slope_start, slope_end, n);  // your code instead of this line
  //@ solution
  const double h = 2.0 * pi / n;
  return h * h / 12.0 * (slope_end - slope_start);
  //@ wrong midpoint_constant: this is the error of the midpoint rule
  const double h = 2.0 * pi / n;
  return -h * h / 24.0 * (slope_end - slope_start);
  //@ end
}

// Task 3: leading term of rule minus integral for a periodic function whose slope jumps once, at
// the fraction theta of the way from one node to the next.
double corner_error(double jump, double theta, int n) {
  //@ starter
  not_done(jump, theta, n);  // your code instead of this line
  //@ solution
  const double h = 2.0 * pi / n;
  return -0.5 * jump * h * h * (theta * theta - theta + 1.0 / 6.0);
  //@ wrong corner_on_a_node: this holds only where the corner is a node
  static_cast<void>(theta);
  const double h = 2.0 * pi / n;
  return -jump * h * h / 12.0;
  //@ end
}

// Task 4: the rule with n intervals in s, t = s - sin s.
double repaired(const Function& f, int n) {
  //@ starter
  not_done(f, n);  // your code instead of this line
  //@ solution
  return trapezoid([&f](double s) { return f(s - std::sin(s)) * (1.0 - std::cos(s)); }, n);
  //@ wrong forgotten_derivative: the derivative dt/ds is missing
  return trapezoid([&f](double s) { return f(s - std::sin(s)); }, n);
  //@ end
}

// Task 5: leading term of repaired rule minus integral, from the slopes of f at 0 and 2 pi.
double repaired_error(double slope_start, double slope_end, int n) {
  //@ starter
  not_done(slope_start, slope_end, n);  // your code instead of this line
  //@ solution
  return std::pow(2.0 * pi / n, 6) / 3024.0 * (slope_end - slope_start);
  //@ wrong fourth_order: this has the order 4
  return -std::pow(2.0 * pi / n, 4) / 720.0 * (slope_end - slope_start);
  //@ end
}
