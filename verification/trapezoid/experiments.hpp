#pragma once

#include <numbers>

#include "study/study.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook::verification::trapezoid {

/// @name Experiments of the study, each in its own file
/// @{
study::Experiment published_table();
study::Experiment smoothness();
study::Experiment pole_rates();
study::Experiment interpolation_rates();
study::Experiment perimeters();
study::Experiment ellipse_spectrum();
study::Experiment graded_poles();
study::Experiment graded_counts();
study::Experiment rules();
/// @}

/// Returns the parameters 2 pi j / n of the nodes.
inline Eigen::VectorXd parameters(Eigen::Index n) {
  const double h = 2.0 * std::numbers::pi / static_cast<double>(n);
  return Eigen::VectorXd::LinSpaced(n, 0.0, h * static_cast<double>(n - 1));
}

/// Integrates a function of period 2 pi by the trapezoid rule. All weights are 2 pi / n.
template <class Function>
double trapezoid_rule(Eigen::Index n, const Function& f) {
  return 2.0 * std::numbers::pi * parameters(n).unaryExpr(f).mean();
}

/// A planted defect: the rule counts one node twice. The function is periodic, so that the last
/// node is the first node.
template <class Function>
double rule_with_both_ends(Eigen::Index n, const Function& f) {
  return trapezoid_rule(n, f) + 2.0 * std::numbers::pi / static_cast<double>(n) * f(0.0);
}

/// Represents 1 / (cosh d - cos t), which has poles at a distance d from the real axis and modes
/// e^{-d |k|} / sinh d.
class PoleFunction {
 public:
  explicit PoleFunction(double distance) : distance_(distance) {}

  double operator()(double t) const { return 1.0 / denominator(t); }
  double derivative(double t) const { return -std::sin(t) / (denominator(t) * denominator(t)); }
  double integral() const { return 2.0 * std::numbers::pi / std::sinh(distance_); }
  double distance() const { return distance_; }

 private:
  /// Returns cosh d - cos t without cancellation near the poles.
  double denominator(double t) const {
    const double hyperbolic = std::sinh(0.5 * distance_), circular = std::sin(0.5 * t);
    return 2.0 * (hyperbolic * hyperbolic + circular * circular);
  }

  double distance_;
};

}  // namespace stokesbook::verification::trapezoid
