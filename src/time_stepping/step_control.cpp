// Measures errors of steps (09.9), and chooses the length of the first step and of each following
// step (09.10).
#include "time_stepping/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stokesbook {

using Eigen::VectorXd;

double ErrorBound::in_units_of_scale(const VectorXd& error) const {
  return error.cwiseQuotient(scale).lpNorm<Eigen::Infinity>();
}

// [factor]
// 0.9 e_n^(-0.7/m) e_(n-1)^(0.4/m), bounded (09.10)
double step_factor(double error, double previous, int order) {
  constexpr double safety = 0.9, least = 0.2, most = 5.0;
  const double history = std::pow(std::max(previous, 1e-4), 0.4 / order);
  const double factor = safety * history * std::pow(error, -0.7 / order);
  return factor > least ? std::min(factor, most) : least;  // least also if NaN
}
// [factor]

double first_step(const Rate& f, const TimePoint& start, const ErrorBound& bound, int order) {
  const double speed = bound.in_units_of_scale(start.rate);
  if (speed == 0.0) return std::numeric_limits<double>::infinity();
  const double trial = 0.01 / speed;
  VectorXd rate;
  try {
    rate = f(start.t + trial, start.state + trial * start.rate);
  } catch (const InadmissibleState&) {
    return trial;  // the step is halved if it meets such a state, too
  }
  // First and second derivative, in units of the bound and of the time 1 / speed, in which q
  // changes by its scale.
  const double first = 1.0 / bound.tolerance,
               second = bound(rate - start.rate) / (trial * speed * speed);
  return std::min(100.0 * trial, std::pow(0.01 / std::max(first, second), 1.0 / order) / speed);
}

}  // namespace stokesbook
