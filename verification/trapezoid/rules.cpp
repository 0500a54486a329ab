// Compares error and work of the trapezoid rule with rules for an interval: Gauss-Legendre and
// Simpson.
#include <chrono>
#include <cmath>
#include <memory>

#include <gsl/gsl_integration.h>

#include "experiments.hpp"

namespace stokesbook::verification::trapezoid {

using namespace study;
using Eigen::Index;

namespace {

constexpr double distance = 0.3;
const PoleFunction integrand(distance);

double trapezoid(Index n) {
  return trapezoid_rule(n, integrand);
}

/// Integrates by Simpson's rule, with weights h/3 (4, 2, 4, 2, ...). On a circle its error is the
/// error of the trapezoid rule with half as many nodes.
double simpson(Index n) {
  const double odd = trapezoid_rule(n, integrand), even = trapezoid_rule(n / 2, integrand);
  return (4.0 * odd - even) / 3.0;
}

/// Integrates by the rule on [-end, end].
double gauss_legendre_up_to(double end, Index n) {
  const std::unique_ptr<gsl_integration_fixed_workspace, void (*)(gsl_integration_fixed_workspace*)>
      rule(gsl_integration_fixed_alloc(gsl_integration_fixed_legendre, static_cast<std::size_t>(n),
                                       -end, end, 0.0, 0.0),
           gsl_integration_fixed_free);
  const Eigen::Map<const Eigen::VectorXd> nodes(gsl_integration_fixed_nodes(rule.get()), n);
  const Eigen::Map<const Eigen::VectorXd> w(gsl_integration_fixed_weights(rule.get()), n);
  return w.dot(nodes.unaryExpr(integrand));
}

double gauss_legendre(Index n) {
  return gauss_legendre_up_to(std::numbers::pi, n);
}

/// A planted defect: the interval is shorter than the period.
double short_gauss_legendre(Index n) {
  return gauss_legendre_up_to(0.999 * std::numbers::pi, n);
}

double seconds_of(double (*rule)(Index), Index n) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  constexpr int repeats = 20;
  for (int k = 0; k < repeats; ++k) rule(n);
  return std::chrono::duration<double>(Clock::now() - start).count() / repeats;
}

Measure measure(double (*rule)(Index)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index n = 8; n <= 240; n += size == Size::full ? 8 : 16) {
      measurements.push_back({.x = static_cast<double>(n),
                              .error = std::abs(rule(n) / integrand.integral() - 1.0),
                              .operations = static_cast<double>(n),
                              .seconds = seconds_of(rule, n)});
    }
    return measurements;
  };
}

}  // namespace

Experiment rules() {
  // Poles at +-i d relative to the interval [-pi, pi]: the rate follows from the ellipse through
  // the poles with foci at the ends of the interval.
  const double rho = distance / std::numbers::pi + std::hypot(1.0, distance / std::numbers::pi);
  return {.key = "rules",
          .title = "Rules for the same periodic function",
          .x = "evaluations N",
          .error = "relative error of the integral",
          .axes = Axes::semi_log,
          .lines = {{.key = "trapezoid", .label = "trapezoid", .measure = measure(trapezoid)},
                    {.key = "gauss",
                     .label = "Gauss-Legendre on one period",
                     .measure = measure(gauss_legendre),
                     .claim = Claim{.id = "01_14",
                                    .statement = "Gauss-Legendre, the best rule on an interval, "
                                                 "needs about pi / 2 times as many nodes as the "
                                                 "trapezoid rule on a period.",
                                    .law = Geometric{2.0 * std::log(rho), 0.04},
                                    .window = {.from = 40.0, .floor = 1e-15},
                                    .reason = "rho^{-2 N}, rho = d / pi + sqrt(1 + (d / pi)^2): "
                                              "the ellipse through the poles"},
                     .control = Control{"an interval too short by a thousandth",
                                        measure(short_gauss_legendre)}},
                    {.key = "simpson", .label = "Simpson", .measure = measure(simpson)}},
          .work_precision = true,
          .operation = "evaluations"};
}

}  // namespace stokesbook::verification::trapezoid
