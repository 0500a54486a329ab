// Exercise 04.4: five drills on walls that enclose the fluid.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: the velocity along n on the outer circle, if that on the inner circle is v.
double wall_speed(double inner_radius, double outer_radius, double v) {
  //@ starter
  not_done(inner_radius, outer_radius, v);  // your code instead of this line
  //@ solution
  return -v * inner_radius / outer_radius;
  //@ wrong equal_speeds: the circles have different lengths
  static_cast<void>(inner_radius), static_cast<void>(outer_radius);
  return -v;
  //@ wrong away_from_the_centre: this is the velocity away from the centre
  return v * inner_radius / outer_radius;
  //@ end
}

// Task 2: the flux of the density n |x'| of an ellipse.
double invisible_flux(double a, double b) {
  //@ starter
  not_done(a, b);  // your code instead of this line
  //@ solution
  return pi * (a * a + b * b);
  //@ wrong twice_the_area: this is right on a circle only
  return 2.0 * pi * a * b;
  //@ wrong half: the mean of a squared sine is one half
  return 2.0 * pi * (a * a + b * b);
  //@ end
}

// Task 3: the net flux of the data, from the density that solves the equation with N_0.
double net_flux_of_data(const ComplexVector& normals, const ComplexVector& density,
                        const Eigen::VectorXd& weights) {
  //@ starter
  not_done(normals, density, weights);  // your code instead of this line
  //@ solution
  double flux = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) {
    flux -= weights[j] * dot(normals[j], density[j]);
  }
  return flux;
  //@ wrong flux_of_the_density: the flux of the density is -Q
  double flux = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) {
    flux += weights[j] * dot(normals[j], density[j]);
  }
  return flux;
  //@ wrong mean: this is divided by the length of the wall
  double flux = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) {
    flux -= weights[j] * dot(normals[j], density[j]) / weights.sum();
  }
  return flux;
  //@ end
}

// Task 4: the torque of the wall on the fluid, about a point.
double wall_torque(const ComplexVector& forces, const Eigen::VectorXd& torques,
                   const ComplexVector& centres, Complex about) {
  //@ starter
  not_done(forces, torques, centres, about);  // your code instead of this line
  //@ solution
  double sum = torques.sum();
  for (Eigen::Index k = 0; k < forces.size(); ++k) sum += cross(centres[k] - about, forces[k]);
  return -sum;
  //@ wrong no_arms: the forces have torques too
  static_cast<void>(forces), static_cast<void>(centres), static_cast<void>(about);
  return -torques.sum();
  //@ wrong torque_of_the_bodies: this is the torque of the bodies
  double sum = torques.sum();
  for (Eigen::Index k = 0; k < forces.size(); ++k) sum += cross(centres[k] - about, forces[k]);
  return sum;
  //@ wrong other_arms: the arms have the other direction
  double sum = torques.sum();
  for (Eigen::Index k = 0; k < forces.size(); ++k) sum += cross(about - centres[k], forces[k]);
  return -sum;
  //@ end
}

// Task 5: the rate of the error of a load between two circles.
double load_rate(double inner_radius, double outer_radius, double e) {
  //@ starter
  not_done(inner_radius, outer_radius, e);  // your code instead of this line
  //@ solution
  const double twice = 2.0 * std::log(outer_radius / (inner_radius + e));
  const double sum = inner_radius * inner_radius + outer_radius * outer_radius - e * e;
  return std::min(twice, std::acosh(sum / (2.0 * inner_radius * outer_radius)));
  //@ wrong first_order: this is the rate of the density's alias
  const double once = std::log(outer_radius / (inner_radius + e));
  const double sum = inner_radius * inner_radius + outer_radius * outer_radius - e * e;
  return std::min(once, std::acosh(sum / (2.0 * inner_radius * outer_radius)));
  //@ wrong larger_rate: the larger rate belongs to the smaller error
  const double twice = 2.0 * std::log(outer_radius / (inner_radius + e));
  const double sum = inner_radius * inner_radius + outer_radius * outer_radius - e * e;
  return std::max(twice, std::acosh(sum / (2.0 * inner_radius * outer_radius)));
  //@ end
}
