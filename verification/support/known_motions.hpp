#pragma once

#include <cmath>
#include <numbers>

namespace stokesbook::test {

/// Returns the angle theta at time t of an ellipse with aspect ratio lambda in shear of rate 1. The
/// ellipse starts at the angle 0. The formula is
/// tan theta = -tan(lambda t / (1 + lambda^2)) / lambda, continued beyond the half turns.
inline double jeffery_angle(double lambda, double t) {
  const double phase = lambda * t / (1.0 + lambda * lambda);
  const double half_turns = std::round(phase / std::numbers::pi);
  return -half_turns * std::numbers::pi -
         std::atan(std::tan(phase - half_turns * std::numbers::pi) / lambda);
}

/// Returns the distance D = 2 cosh(al) of the centres of two unit circles at time t in the flow
/// u = (-x, y). The equation 2 al - coth al = const - 2 t determines al.
inline double circle_distance(double start, double t) {
  const auto invariant = [](double al) { return 2.0 * al - 1.0 / std::tanh(al); };
  const double target = invariant(std::acosh(0.5 * start)) - 2.0 * t;
  double low = 1e-9, high = std::acosh(0.5 * start);
  for (int bisection = 0; bisection < 200; ++bisection) {
    const double middle = 0.5 * (low + high);
    (invariant(middle) < target ? low : high) = middle;
  }
  return 2.0 * std::cosh(0.5 * (low + high));
}

}  // namespace stokesbook::test
