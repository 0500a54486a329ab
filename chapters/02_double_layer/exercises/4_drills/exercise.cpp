// Exercise 02.4: five drills on the double layer and on the Stokeslet.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

enum class Place { in_the_fluid, on_the_curve, beyond_the_curve };

// Task 1: the double layer of the density 1.
double layer_of_constant(Side side, Place place) {
  //@ starter
  not_done(side, place);  // your code instead of this line
  //@ solution
  const double on_curve = side == Side::fluid_outside ? 0.5 : -0.5;
  if (place == Place::on_the_curve) return on_curve;
  return place == Place::in_the_fluid ? on_curve - 0.5 : on_curve + 0.5;
  //@ wrong jump_sign: the jump has the other sign
  const double on_curve = side == Side::fluid_outside ? 0.5 : -0.5;
  if (place == Place::on_the_curve) return on_curve;
  return place == Place::in_the_fluid ? on_curve + 0.5 : on_curve - 0.5;
  //@ wrong always_a_body: these are the numbers of a body
  static_cast<void>(side);
  if (place == Place::on_the_curve) return 0.5;
  return place == Place::in_the_fluid ? 0.0 : 1.0;
  //@ end
}

// Task 2: the pressure of a Stokeslet at r, target minus source.
double pressure(Complex r, Complex force) {
  //@ starter
  not_done(r, force);  // your code instead of this line
  //@ solution
  return dot(r, force) / (2.0 * pi * std::norm(r));
  //@ wrong factor_of_the_velocity: this has the factor of the velocity
  return dot(r, force) / (4.0 * pi * std::norm(r));
  //@ wrong direction_only: this does not decay
  return dot(r, force) / (2.0 * pi * std::abs(r));
  //@ end
}

// Task 3: the torque that acts at `to` if the force acts there, and no longer at `from`.
double moved_torque(Complex force, double torque, Complex from, Complex to) {
  //@ starter
  not_done(force, torque, from, to);  // your code instead of this line
  //@ solution
  return torque + cross(from - to, force);
  //@ wrong other_arm: the arm has the other direction
  return torque + cross(to - from, force);
  //@ wrong unchanged: the force has a torque about the new point
  static_cast<void>(force), static_cast<void>(from), static_cast<void>(to);
  return torque;
  //@ end
}

// Task 4: the velocity that is added if the gauge length changes.
Complex gauge_shift(Complex force, double viscosity, double before, double after) {
  //@ starter
  not_done(force, viscosity, before, after);  // your code instead of this line
  //@ solution
  return std::log(after / before) / (4.0 * pi * viscosity) * force;
  //@ wrong other_sign: the sign is the other one
  return std::log(before / after) / (4.0 * pi * viscosity) * force;
  //@ wrong squares: a square root is missing
  return std::log(after * after / (before * before)) / (4.0 * pi * viscosity) * force;
  //@ end
}

// Task 5: what the double layer of a body drives out of a large circle.
double outflow(const ComplexVector& normals, const ComplexVector& density,
               const Eigen::VectorXd& weights) {
  //@ starter
  not_done(normals, density, weights);  // your code instead of this line
  //@ solution
  double sum = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) sum += weights[j] * dot(normals[j], density[j]);
  return sum;
  //@ wrong into_the_circle: this is what flows into the circle
  double sum = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) sum -= weights[j] * dot(normals[j], density[j]);
  return sum;
  //@ wrong complex_product: this is the real part of the complex product
  double sum = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) {
    sum += weights[j] * (normals[j] * density[j]).real();
  }
  return sum;
  //@ end
}
