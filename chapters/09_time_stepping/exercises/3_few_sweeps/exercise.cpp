// Exercise 09.3: where one sweep a step, and Euler's steps, break.
#include "chapters/exercise.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Core>

using Eigen::VectorXd;
using std::numbers::pi;
using stokesbook::exercise::not_done;

using Linear = std::function<VectorXd(const VectorXd&)>;

struct System {
  Linear a;          // A
  Linear inverse_m;  // M^-1
  VectorXd b;
};

// Task 1: the density after sweeps of block Jacobi.
VectorXd sweeps(const System& system, const VectorXd& before, int count) {
  //@ starter
  not_done(system, before, count);  // your code instead of this line
  //@ solution
  VectorXd density = before;
  for (int k = 0; k < count; ++k) density += system.inverse_m(system.b - system.a(density));
  return density;
  //@ wrong forgotten: the density before is missing in the sum
  VectorXd density = before;
  for (int k = 0; k < count; ++k) density = system.inverse_m(system.b - system.a(density));
  return density;
  //@ wrong frozen: every sweep starts from the density of the step before
  VectorXd density = before;
  for (int k = 0; k < count; ++k) density = before + system.inverse_m(system.b - system.a(before));
  return density;
  //@ end
}

// Task 2: the factor of the error by one sweep, two circles of radius 1.
double contraction(double gap) {
  //@ starter
  not_done(gap);  // your code instead of this line
  //@ solution
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  return std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
  //@ wrong distance: the gap is not the distance of the centres
  const double alpha = std::acosh(1.0 + gap);
  return std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
  //@ end
}

// Task 3: the gap below which k sweeps leave more than half of an error.
double breaking_gap(int k) {
  //@ starter
  not_done(k);  // your code instead of this line
  //@ solution
  double low = 1e-6, high = 10.0;
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double middle = std::sqrt(low * high);
    (std::pow(contraction(middle), k) > 0.5 ? low : high) = middle;
  }
  return std::sqrt(low * high);
  //@ wrong asymptotic: the law for small gaps does not hold there
  return std::pow((1.0 - std::pow(0.5, 1.0 / k)) / 8.0, 2.0 / 3.0);
  //@ end
}

// Task 4: relative error after k sweeps in steps of length dt that follow a reversal.
double error_after_reversal(double gap, int k, double dt) {
  //@ starter
  not_done(gap, k, dt);  // your code instead of this line
  //@ solution
  static_cast<void>(dt);  // which has no say in it
  return 2.0 * std::pow(contraction(gap), k);
  //@ wrong first_order: the time step does not help
  return 2.0 * dt * std::pow(contraction(gap), k);
  //@ wrong from_nothing: the density before is -eta, not 0
  static_cast<void>(dt);
  return std::pow(contraction(gap), k);
  //@ end
}

// Task 5: the factor by which a circle has grown after a turn of n Euler steps.
double growth(int n) {
  //@ starter
  not_done(n);  // your code instead of this line
  //@ solution
  const double h = 2.0 * pi / n;
  return std::pow(1.0 + h * h, 0.5 * n);
  //@ wrong modulus: this is the square of the modulus
  const double h = 2.0 * pi / n;
  return std::pow(1.0 + h * h, n);
  //@ end
}
