#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "support/known_motions.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook::test {

/// The test problem consists of the angle of a slender ellipse in shear, and of an equation that
/// depends on time. Both equations are nonlinear:
/// theta' = -(a^2 sin^2 theta + b^2 cos^2 theta) / (a^2 + b^2) and y' = cos t (1 + y^2).
inline constexpr double aspect = 3.0;

inline Eigen::VectorXd problem_rate(double t, const Eigen::VectorXd& q) {
  const double s = aspect * std::sin(q[0]), c = std::cos(q[0]);
  return Eigen::Vector2d{-(s * s + c * c) / (aspect * aspect + 1.0),
                         std::cos(t) * (1.0 + q[1] * q[1])};
}

inline Eigen::VectorXd problem_solution(double t) {
  return Eigen::Vector2d{jeffery_angle(aspect, t), std::tan(std::sin(t))};
}

inline double problem_error(double t, const Eigen::VectorXd& q) {
  return (q - problem_solution(t)).lpNorm<Eigen::Infinity>();
}

inline TimePoint problem_at(double t) {
  const Eigen::VectorXd q = problem_solution(t);
  return {t, q, problem_rate(t, q)};
}

/// Returns settings under which only an event limits the length of a step.
inline SteppingSettings unlimited(SteppingMethod method) {
  SteppingSettings settings{.method = method, .dt = 1e6};
  settings.bound = {1e6, Eigen::VectorXd::Ones(2)};
  return settings;
}

/// Advances to the given times, and returns all steps.
inline std::vector<Step> steps_through(const Stepper& stepper, TimePoint now,
                                       const std::vector<double>& times) {
  std::vector<Step> steps;
  StepMemory memory;
  for (const double t : times) {
    while (now.t < t) {
      StepResult taken = stepper.advance(now, memory, t);
      now = taken.step.end;
      memory = taken.memory;
      steps.push_back(std::move(taken.step));
    }
  }
  return steps;
}

}  // namespace stokesbook::test
