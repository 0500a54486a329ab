// Exercise 03.3: the resistance problem of the plane, broken and repaired.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "closure/closure.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Given: an ellipse in unbounded fluid that moves with the velocity (1, 0.5), viscosity 1.
StokesProblem held_ellipse(const Ellipse& ellipse, double gauge);

// Given: the condition number of a problem's reduced system in the maximum norm.
double condition(const StokesProblem& problem);

// Given: motions and loads.
Completion solve(const StokesProblem& problem);

// Task 1: force of a circle on the fluid along its motion, over its speed.
double drag(double radius, double viscosity, double gauge) {
  //@ starter
  not_done(radius, viscosity, gauge);  // your code instead of this line
  //@ solution
  return 4.0 * pi * viscosity / (0.5 - std::log(radius / gauge));
  //@ wrong logarithm_alone: the 1/2 is missing
  return 4.0 * pi * viscosity / -std::log(radius / gauge);
  //@ wrong on_the_body: this is the force of the fluid on the circle
  return -4.0 * pi * viscosity / (0.5 - std::log(radius / gauge));
  //@ end
}

// Task 2: the larger gauge length for which an ellipse, a > b, cannot be held.
double degenerate_gauge(const Ellipse& ellipse) {
  //@ starter
  not_done(ellipse);  // your code instead of this line
  //@ solution
  const double a = ellipse.a, b = ellipse.b;
  return 0.5 * (a + b) * std::exp(-b / (a + b));
  //@ wrong smaller: this is the smaller one
  const double a = ellipse.a, b = ellipse.b;
  return 0.5 * (a + b) * std::exp(-a / (a + b));
  //@ wrong upside_down: the exponent has the other sign
  const double a = ellipse.a, b = ellipse.b;
  return 0.5 * (a + b) * std::exp(b / (a + b));
  //@ end
}

// Task 3: a gauge length for which the condition number is near the one wanted.
double breaking_gauge(const Ellipse& ellipse, double wanted) {
  //@ starter
  not_done(ellipse, wanted);  // your code instead of this line
  //@ solution
  const double degenerate = degenerate_gauge(ellipse), distance = 1e-3;
  const double known = condition(held_ellipse(ellipse, degenerate * (1.0 + distance)));
  return degenerate * (1.0 + distance * known / wanted);
  //@ wrong on_the_spot: this is the degenerate gauge itself
  static_cast<void>(wanted);
  return degenerate_gauge(ellipse);
  //@ wrong constant_one: this takes 1 for the constant
  return degenerate_gauge(ellipse) * (1.0 + 1.0 / wanted);
  //@ end
}

// Task 4: the same bodies and motions, with loads that do not depend on a gauge length.
StokesProblem repaired(StokesProblem problem) {
  //@ starter
  not_done(problem);  // your code instead of this line
  //@ solution
  problem.gauge_length.reset();
  return problem;
  //@ wrong far_gauge: the loads still depend on a gauge length
  problem.gauge_length = 1e9;
  return problem;
  //@ wrong gauge_of_one: a gauge length of 1 is still one
  problem.gauge_length = 1.0;
  return problem;
  //@ end
}
