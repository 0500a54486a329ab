// Shows that the Cauchy scheme at a fixed small distance converges as fast as the density.
#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "near_singular/interpolation.hpp"
#include "set_ups.hpp"
#include "support/over_nodes.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

constexpr double fixed_distance = 1e-3;

/// Returns a set-up with a pole in the ellipse (1, 1/2). The pole's preimage has the imaginary part
/// `height`.
SetUp pole_at(double height, Index n) {
  const Complex t{0.7, height};
  const Complex pole = std::cos(t) + 0.5 * imaginary * std::sin(t);
  return {Ellipse{1.0, 0.5}, Side::fluid_outside, n, {{{pole, {0.05, -0.03}, 0.04}}}};
}

template <class Method>
Measure errors_over_nodes(double height, const Method& method) {
  const auto error = [=](Index n) {
    const Solved solved(pole_at(height, n));
    const ComplexVector points = solved.points_off(fixed_distance);
    return solved.error(method(solved, points), points);
  };
  return test::over_nodes(16.0, 70.0 / height, 28, error, 2.0);
}

ComplexVector plain_velocity(const Solved& solved, const ComplexVector& points) {
  return StressletSum({solved.curve})(points, solved.density);
}

ComplexVector interpolated_velocity(const Solved& solved, const ComplexVector& points) {
  const InterpolationCurve curve(solved.curve, InterpolationSettings::for_tolerance(1e-10));
  return curve.velocity(curve.data(solved.density), 0, points);
}

ComplexVector cauchy_velocity(const Solved& solved, const ComplexVector& points) {
  const CauchyCurve curve(solved.curve);
  return curve.velocity(curve.data(solved.density), 0, points);
}

/// A planted defect: the weights are not divided by their sum.
ComplexVector uncompensated_velocity(const Solved& solved, const ComplexVector& points) {
  return divided_by([](Complex) { return Complex{1.0}; }, solved.curve,
                    CauchyCurve(solved.curve).data(solved.density), points);
}

}  // namespace

Experiment convergence() {
  constexpr double height = 0.3;
  return {
      .key = "convergence",
      .title = "A thousandth from an ellipse, with a pole of the flow inside",
      .x = "nodes N",
      .error = "error of the velocity, relative to the largest on the curve",
      .axes = Axes::semi_log,
      .lines = {{.key = "plain",
                 .label = "trapezoid rule",
                 .measure = errors_over_nodes(height, plain_velocity)},
                {.key = "interpolation",
                 .label = "interpolation for 1e-10",
                 .measure = errors_over_nodes(height, interpolated_velocity)},
                {.key = "cauchy",
                 .label = "Cauchy integrals",
                 .measure = errors_over_nodes(height, cauchy_velocity),
                 .claim = Claim{.id = "06_12",
                                .statement = "At a thousandth from the curve the Cauchy scheme "
                                             "converges as N e^{-0.15 N}, half of the distance 0.3 "
                                             "of the pole's preimage.",
                                .law = Geometric{0.5 * height, 0.05, 1.0},
                                .window = {.from = 40.0, .floor = 1e-14},
                                .reason = "the density's modes fall as k e^{-0.3 k}, and N nodes "
                                          "hold those up to k = N/2",
                                .api = {"stokesbook::CauchyCurve"}},
                 .control = Control{"weights that are not divided by their sum",
                                    errors_over_nodes(height, uncompensated_velocity)}}}};
}

}  // namespace stokesbook::verification::near_singular
