// Exercise 10.3: the third law, and who sees it broken.
#include "chapters/exercise.hpp"

#include <cmath>
#include <complex>
#include <utility>

#include <Eigen/Core>

using Complex = std::complex<double>;
using Eigen::Vector3d;
using stokesbook::exercise::not_done;

inline double dot(Complex a, Complex b) {
  return std::real(std::conj(a) * b);
}

inline double cross(Complex a, Complex b) {
  return std::imag(std::conj(a) * b);
}

// A body's centre, the force on it, and the torque about its centre.
struct Load {
  Complex centre, force;
  double torque;
};

// Task 1: (F_x, F_y, T) about the origin.
Vector3d imbalance(const Load& a, const Load& b) {
  //@ starter
  not_done(a, b);  // your code instead of this line
  //@ solution
  const Complex force = a.force + b.force;
  const double torque = cross(a.centre, a.force) + a.torque + cross(b.centre, b.force) + b.torque;
  return {force.real(), force.imag(), torque};
  //@ wrong own_centres: torques about two points cannot be added
  const Complex force = a.force + b.force;
  return {force.real(), force.imag(), a.torque + b.torque};
  //@ end
}

// Task 2: the pushes on A and on B by absolute velocities.
std::pair<Complex, Complex> absolute_pushes(Complex u_a, Complex u_b, Complex n) {
  //@ starter
  not_done(u_a, u_b, n);  // your code instead of this line
  //@ solution
  const auto push = [](Complex u, Complex m) -> Complex {
    const double speed = dot(u, m);
    return speed == 0.0 ? 0.0 : -std::copysign(1.0, speed) * m;
  };
  return {push(u_a, n), push(u_b, -n)};
  //@ wrong relative: this is what it should be
  const double speed = dot(u_a - u_b, n);
  const Complex push = -std::copysign(1.0, speed) * n;
  return {push, -push};
  //@ wrong one_normal: B's outward normal is -n, twice
  const auto push = [](Complex u, Complex m) -> Complex {
    const double speed = dot(u, m);
    return speed == 0.0 ? 0.0 : -std::copysign(1.0, speed) * m;
  };
  return {push(u_a, n), -push(u_b, -n)};
  //@ end
}

// Task 3: the least and the largest velocity along n of observers who see opposite pushes.
std::pair<double, double> harmless_observers(Complex u_a, Complex u_b, Complex n) {
  //@ starter
  not_done(u_a, u_b, n);  // your code instead of this line
  //@ solution
  return {dot(u_b, n), dot(u_a, n)};
  //@ wrong any_velocity: the velocity along n counts
  static_cast<void>(n);
  return {-std::abs(u_b), std::abs(u_a)};
  //@ wrong around_zero: the observer at rest is nobody special
  const double half = 0.5 * dot(u_a - u_b, n);
  return {-half, half};
  //@ end
}

// Task 4: the sum of the torques about the centres at the start, displacements given.
double torque_left(Complex displacement_a, Complex displacement_b, Complex n) {
  //@ starter
  not_done(displacement_a, displacement_b, n);  // your code instead of this line
  //@ solution
  return -cross(displacement_a - displacement_b, n);
  //@ wrong sign: from the end back to the start
  return cross(displacement_a - displacement_b, n);
  //@ wrong sum: forces are opposite
  return -cross(displacement_a + displacement_b, n);
  //@ end
}
