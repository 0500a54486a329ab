// Exercise 03.4: five drills on rigid motions and loads.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

//@ starter
//@ solution
// The mean over the length of the curve.
Complex mean(const ComplexVector& values, const Eigen::VectorXd& weights) {
  return values.cwiseProduct(weights).sum() / weights.sum();
}

//@ end
// Task 1: the velocity of the point x.
Complex point_velocity(Complex velocity, double omega, Complex centre, Complex x) {
  //@ starter
  not_done(velocity, omega, centre, x);  // your code instead of this line
  //@ solution
  return velocity + omega * perp(x - centre);
  //@ wrong clockwise: this turns the body clockwise
  return velocity - omega * perp(x - centre);
  //@ wrong about_the_origin: this turns the body about the origin
  static_cast<void>(centre);
  return velocity + omega * perp(x);
  //@ end
}

// Task 2: the root mean square distance from the centroid.
double gyration_radius(const ComplexVector& x, const Eigen::VectorXd& weights) {
  //@ starter
  not_done(x, weights);  // your code instead of this line
  //@ solution
  const Complex centroid = mean(x, weights);
  return std::sqrt(weights.dot((x.array() - centroid).abs2().matrix()) / weights.sum());
  //@ wrong from_the_origin: this is the distance from the origin
  return std::sqrt(weights.dot(x.cwiseAbs2()) / weights.sum());
  //@ wrong over_the_nodes: these are means over the nodes
  static_cast<void>(weights);
  return std::sqrt((x.array() - x.mean()).abs2().mean());
  //@ end
}

// Task 3: the angular velocity of the nearest rigid motion.
double mean_rotation(const ComplexVector& x, const Eigen::VectorXd& weights,
                     const ComplexVector& density) {
  //@ starter
  not_done(x, weights, density);  // your code instead of this line
  //@ solution
  const Complex centroid = mean(x, weights);
  double moment = 0.0, square = 0.0;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    moment += weights[j] * cross(x[j] - centroid, density[j]);
    square += weights[j] * std::norm(x[j] - centroid);
  }
  return moment / square;
  //@ wrong divided_once: this is a velocity
  const Complex centroid = mean(x, weights);
  double moment = 0.0, square = 0.0;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    moment += weights[j] * cross(x[j] - centroid, density[j]) / weights.sum();
    square += weights[j] * std::norm(x[j] - centroid) / weights.sum();
  }
  return moment / std::sqrt(square);
  //@ wrong moment_about_the_origin: a translation has a moment about the origin
  double moment = 0.0, square = 0.0;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    moment += weights[j] * cross(x[j], density[j]);
    square += weights[j] * std::norm(x[j]);
  }
  return moment / square;
  //@ end
}

// Task 4: the angular velocity under a force at c, from the velocity of c under a unit torque.
double turn_by_force(Complex velocity_under_torque, Complex force) {
  //@ starter
  not_done(velocity_under_torque, force);  // your code instead of this line
  //@ solution
  return dot(velocity_under_torque, force);
  //@ wrong cross_product: this is the cross product
  return cross(velocity_under_torque, force);
  //@ wrong opposite: the mobility matrix is symmetric
  return -dot(velocity_under_torque, force);
  //@ end
}

// Task 5: the forces of the held bodies.
ComplexVector held_forces(const ComplexVector& velocities, double viscosity, Complex free_forces) {
  //@ starter
  not_done(velocities, viscosity, free_forces);  // your code instead of this line
  //@ solution
  const double count = static_cast<double>(velocities.size());
  return -4.0 * pi * viscosity * (velocities.array() - velocities.mean()) - free_forces / count;
  //@ wrong mean_left_in: the mean velocity is not subtracted
  const double count = static_cast<double>(velocities.size());
  return -4.0 * pi * viscosity * velocities.array() - free_forces / count;
  //@ wrong free_bodies_forgotten: the forces of the held bodies alone add up to zero
  static_cast<void>(free_forces);
  return -4.0 * pi * viscosity * (velocities.array() - velocities.mean());
  //@ end
}
