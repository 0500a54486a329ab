// Exercise 02.2: what a body does to the fluid, measured far away, and its completion.
#include "chapters/exercise.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "double_layer/kernels.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

using Velocity = std::function<Complex(Complex)>;

// Mean of g(t) over n equidistant angles t: yours to use.
template <class Function>
auto mean_over_angles(const Function& g) {
  constexpr int n = 256;
  auto sum = g(0.0);
  for (int j = 1; j < n; ++j) sum += g(2.0 * pi * j / n);
  return sum / static_cast<double>(n);
}

// Task 1: force on the fluid, from circles with the radii inner < outer.
Complex force(const Velocity& u, double viscosity, double inner, double outer) {
  //@ starter
  not_done(u, viscosity, inner, outer);  // your code instead of this line
  //@ solution
  const auto mean = [&](double radius) {
    return mean_over_angles([&](double t) { return u(std::polar(radius, t)); });
  };
  return 4.0 * pi * viscosity / std::log(outer / inner) * (mean(inner) - mean(outer));
  //@ wrong by_the_fluid: this is the force by the fluid
  const auto mean = [&](double radius) {
    return mean_over_angles([&](double t) { return u(std::polar(radius, t)); });
  };
  return 4.0 * pi * viscosity / std::log(outer / inner) * (mean(outer) - mean(inner));
  //@ wrong no_viscosity: the viscosity is missing
  const auto mean = [&](double radius) {
    return mean_over_angles([&](double t) { return u(std::polar(radius, t)); });
  };
  static_cast<void>(viscosity);
  return 4.0 * pi / std::log(outer / inner) * (mean(inner) - mean(outer));
  //@ end
}

// Task 2: counter-clockwise torque on the fluid about the origin.
double torque(const Velocity& u, double viscosity, double radius) {
  //@ starter
  not_done(u, viscosity, radius);  // your code instead of this line
  //@ solution
  const double along = mean_over_angles(
      [&](double t) { return dot(u(std::polar(radius, t)), imaginary * std::polar(1.0, t)); });
  return 4.0 * pi * viscosity * radius * along;
  //@ wrong circulation: this is the circulation times the viscosity
  const double along = mean_over_angles(
      [&](double t) { return dot(u(std::polar(radius, t)), imaginary * std::polar(1.0, t)); });
  return 2.0 * pi * viscosity * radius * along;
  //@ end
}

// Task 3: volume per time that leaves the circle.
double flux(const Velocity& u, double radius) {
  //@ starter
  not_done(u, radius);  // your code instead of this line
  //@ solution
  return 2.0 * pi * radius * mean_over_angles([&](double t) {
           return dot(u(std::polar(radius, t)), std::polar(1.0, t));
         });
  //@ end
}

// Task 4: a velocity with that force and torque on the fluid, singular at the origin only, of the
// gauge length 1.
Velocity completion(Complex force, double torque, double viscosity) {
  //@ starter
  not_done(force, torque, viscosity);  // your code instead of this line
  //@ solution
  return
      [=](Complex z) { return stokeslet(z, force, viscosity, 1.0) + rotlet(z, torque, viscosity); };
  //@ wrong clockwise: the torque has the other sign
  return
      [=](Complex z) { return stokeslet(z, force, viscosity, 1.0) - rotlet(z, torque, viscosity); };
  //@ wrong unit_strength: 1/(4 pi mu) is missing
  return [=](Complex z) {
    return 4.0 * pi * viscosity *
           (stokeslet(z, force, viscosity, 1.0) + rotlet(z, torque, viscosity));
  };
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
