// Measures the rates of the integral, the interpolant and its derivative of a function with a pole
// at a known distance from the real axis (01.6), (01.7).
#include <cmath>

#include "experiments.hpp"
#include "support/over_nodes.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::trapezoid {

using namespace study;
using Eigen::Index;

namespace {

/// Measures at node counts for which e^{-rate n} decreases from 1 to rounding.
template <class Error>
Measure at_counts(double rate, const Error& error) {
  return test::over_nodes(0.0, 36.0 / rate, 24, error, 1.0);
}

template <class Rule>
auto integral_error(const PoleFunction& f, const Rule& rule) {
  return [=](Index n) { return std::abs(rule(n, f) / f.integral() - 1.0); };
}

Line integral_line(const std::string& key, const std::string& id, double distance) {
  const PoleFunction f(distance);
  const auto rule = [](Index n, const PoleFunction& g) { return trapezoid_rule(n, g); };
  const auto defective = [](Index n, const PoleFunction& g) { return rule_with_both_ends(n, g); };
  return {.key = key,
          .label = "poles at distance " + std::to_string(distance).substr(0, 3),
          .measure = at_counts(distance, integral_error(f, rule)),
          .claim = Claim{.id = id,
                         .statement = "The integral of a function with poles at a distance d from "
                                      "the real axis converges as e^{-d N}, no faster.",
                         .law = Geometric{distance, 0.02},
                         .window = {.from = 2.0 / distance, .floor = 1e-15},
                         .reason = "modes e^{-d |k|} alias: relative error 2 / (e^{d N} - 1)",
                         .api = {"stokesbook::weights"}},
          .control = Control{"the first node counted twice",
                             at_counts(distance, integral_error(f, defective))}};
}

/// Sums of up to 144 modes have this rounding error: one rounding unit for each mode.
constexpr double rounding = 3e-14;

/// Returns the values at the nodes.
ComplexVector samples(const PoleFunction& f, Index n) {
  return parameters(n).unaryExpr(f).cast<Complex>();
}

/// Returns the largest error of the interpolant midway between 64 arbitrary points, relative to the
/// largest value.
double interpolation_error(const PoleFunction& f, Index n) {
  const TrigonometricPolynomial p(samples(f, n));
  double error = 0.0;
  for (int k = 0; k < 64; ++k) {
    const double t = 0.1 * (k + 0.37);
    error = std::max(error, std::abs(p(t).value - f(t)));
  }
  return error / f(0.0);
}

/// Returns the error of the interpolation by straight lines between the nodes.
double linear_interpolation_error(const PoleFunction& f, Index n) {
  const double h = 2.0 * std::numbers::pi / static_cast<double>(n);
  double error = 0.0;
  for (int k = 0; k < 64; ++k) {
    const double t = 0.1 * (k + 0.37), left = h * std::floor(t / h);
    const double share = (t - left) / h;
    error = std::max(error, std::abs((1.0 - share) * f(left) + share * f(left + h) - f(t)));
  }
  return error / f(0.0);
}

template <class Derivative>
auto derivative_error(const PoleFunction& f, const Derivative& derivative) {
  return [=](Index n) {
    const Eigen::VectorXd exact =
        parameters(n).unaryExpr([&](double t) { return f.derivative(t); });
    // There are far more points than nodes, so that the largest derivative does not depend on n.
    const double scale =
        parameters(4096).unaryExpr([&](double t) { return std::abs(f.derivative(t)); }).maxCoeff();
    return (derivative(samples(f, n)) - exact).cwiseAbs().maxCoeff() / scale;
  };
}

/// A planted defect: the modes of the upper half keep the wave numbers n/2 ... n - 1 instead of
/// -n/2 ... -1.
ComplexVector derivative_without_negative_modes(const ComplexVector& f) {
  ComplexVector c = fourier_coefficients(f);
  for (Index i = 0; i < c.size(); ++i) c[i] *= imaginary * static_cast<double>(i);
  return fourier_values(c);
}

}  // namespace

Experiment pole_rates() {
  return {.key = "poles",
          .title = "Poles near the real axis",
          .x = "nodes N",
          .error = "relative error of the integral",
          .axes = Axes::semi_log,
          .lines = {integral_line("far", "01_4", 1.0), integral_line("near", "01_5", 0.3),
                    integral_line("nearer", "01_6", 0.1)}};
}

Experiment interpolation_rates() {
  const double distance = 0.5;
  const PoleFunction f(distance);
  return {
      .key = "interpolation",
      .title = "Interpolation and differentiation",
      .x = "nodes N",
      .error = "largest error, relative to the largest value",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "value",
           .label = "interpolant between the nodes",
           .measure = at_counts(0.5 * distance, [=](Index n) { return interpolation_error(f, n); }),
           .claim = Claim{.id = "01_7",
                          .statement = "The trigonometric interpolant converges as e^{-d N / 2}: "
                                       "half the rate of the integral.",
                          .law = Geometric{0.5 * distance, 0.03},
                          .window = {.from = 4.0 / distance, .floor = rounding},
                          .reason = "modes beyond N / 2 are missing, and alias onto those below",
                          .api = {"stokesbook::TrigonometricPolynomial", "stokesbook::resample"}},
           .control =
               Control{
                   "straight lines between the nodes",
                   at_counts(distance, [=](Index n) { return linear_interpolation_error(f, n); })}},
          {.key = "derivative",
           .label = "derivative at the nodes",
           .measure = at_counts(0.5 * distance, derivative_error(f, differentiate)),
           .claim =
               Claim{.id = "01_8",
                     .statement = "Its derivative converges as N e^{-d N / 2}.",
                     .law = Geometric{0.5 * distance, 0.03, 1.0},
                     .window = {.from = 4.0 / distance, .floor = rounding},
                     .reason = "each mode is multiplied by its wave number, at most N / 2",
                     .api = {"stokesbook::differentiate", "stokesbook::differentiation_matrix"}},
           .control = Control{"the upper half of the modes counted as positive",
                              at_counts(0.5 * distance,
                                        derivative_error(f, derivative_without_negative_modes))}}}};
}

}  // namespace stokesbook::verification::trapezoid
