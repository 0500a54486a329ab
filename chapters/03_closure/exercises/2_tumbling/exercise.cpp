// Exercise 03.2: the orbit of a free ellipse in shear, from single instants.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "closure/closure.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Given: solves a mobility problem, and returns the motion of its first body.
RigidMotion solve(const StokesProblem& problem);

// Task 1: a free ellipse in the flow (rate y, 0).
StokesProblem tumbling(const Ellipse& ellipse, double angle, double rate, int nodes) {
  //@ starter
  not_done(ellipse, angle, rate, nodes);  // your code instead of this line
  //@ solution
  const Curve curve = place(sample(ellipse, nodes, Side::fluid_outside), 0.0, angle);
  const ComplexVector flow = rate * curve.x.imag().cast<Complex>();
  return {{{ComponentKind::free_body, curve, 0.0, 0.0, 0.0, {}}}, 1.0, flow, {}};
  //@ wrong clockwise: this turns the ellipse clockwise
  const Curve curve = place(sample(ellipse, nodes, Side::fluid_outside), 0.0, -angle);
  const ComplexVector flow = rate * curve.x.imag().cast<Complex>();
  return {{{ComponentKind::free_body, curve, 0.0, 0.0, 0.0, {}}}, 1.0, flow, {}};
  //@ wrong own_frame: the flow is taken in the frame of the ellipse
  const Curve own = sample(ellipse, nodes, Side::fluid_outside);
  const Curve curve = place(own, 0.0, angle);
  const ComplexVector flow = rate * own.x.imag().cast<Complex>();
  return {{{ComponentKind::free_body, curve, 0.0, 0.0, 0.0, {}}}, 1.0, flow, {}};
  //@ end
}

// Task 2: B of omega = -rate/2 + B rate/2 cos(2 theta).
double shape_factor(const Ellipse& ellipse, int nodes) {
  //@ starter
  not_done(ellipse, nodes);  // your code instead of this line
  //@ solution
  return solve(tumbling(ellipse, 0.0, 1.0, nodes)).omega -
         solve(tumbling(ellipse, 0.5 * pi, 1.0, nodes)).omega;
  //@ wrong other_order: the sign is the other one
  return solve(tumbling(ellipse, 0.5 * pi, 1.0, nodes)).omega -
         solve(tumbling(ellipse, 0.0, 1.0, nodes)).omega;
  //@ end
}

// Task 3: time for half a turn, by the trapezoid rule with so many angles.
double half_turn(const Ellipse& ellipse, double rate, int angles, int nodes) {
  //@ starter
  not_done(ellipse, rate, angles, nodes);  // your code instead of this line
  //@ solution
  double time = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double omega = solve(tumbling(ellipse, pi * k / angles, rate, nodes)).omega;
    time += pi / angles / std::abs(omega);
  }
  return time;
  //@ wrong mean_turn: this divides by the mean of omega
  double omega = 0.0;
  for (int k = 0; k < angles; ++k) {
    omega += solve(tumbling(ellipse, pi * k / angles, rate, nodes)).omega / angles;
  }
  return pi / std::abs(omega);
  //@ wrong quarter: this is a quarter of a turn
  double time = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double omega = solve(tumbling(ellipse, pi * k / angles, rate, nodes)).omega;
    time += 0.5 * pi / angles / std::abs(omega);
  }
  return time;
  //@ end
}

// Task 4 is an experiment with these functions. You find it in the book's check.cpp.

// Task 5: least number of angles with a relative error of at most the tolerance.
int angles_needed(double aspect, double tolerance) {
  //@ starter
  not_done(aspect, tolerance);  // your code instead of this line
  //@ solution
  const double q = (aspect - 1.0) / (aspect + 1.0);
  return static_cast<int>(std::ceil(std::log(tolerance / (2.0 + tolerance)) / std::log(q)));
  //@ wrong twice_the_rate: this takes q^(2K) for the error
  const double q = (aspect - 1.0) / (aspect + 1.0);
  return static_cast<int>(std::ceil(0.5 * std::log(tolerance / (2.0 + tolerance)) / std::log(q)));
  //@ end
}
