// Measures the errors of the rule off the curve: they follow from the preimage of the target
// (02.15), and each spacing of distance changes them by the same factor (02.16).
#include <numbers>

#include "experiments.hpp"
#include "support/dirichlet.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

/// Returns the density of the flow on n nodes, without the error of a solve on n nodes.
ComplexVector resolved_density(Index n) {
  static const ComplexVector density = [] {
    const Curve wall = sample(two_to_one, 96, Side::fluid_inside);
    return test::density_of(wall, far_flow.velocity(wall.x));
  }();
  return resample(density, n);
}

ComplexVector rule(Index n, const ComplexVector& targets) {
  return plain_rule(sample(two_to_one, n, Side::fluid_inside), resolved_density(n), targets);
}

/// A planted defect: the normal points into the fluid.
ComplexVector inward_normal(Index n, const ComplexVector& targets) {
  return plain_rule(sample(two_to_one, n, Side::fluid_outside), resolved_density(n), targets);
}

/// A planted defect: all nodes have the same weight.
ComplexVector same_weights(Index n, const ComplexVector& targets) {
  const Curve wall = sample(two_to_one, n, Side::fluid_inside);
  return plain_rule(wall, test::with_equal_weights(wall, resolved_density(n)), targets);
}

/// A planted defect: each node has the density of the next node.
ComplexVector shifted_density(Index n, const ComplexVector& targets) {
  ComplexVector density = resolved_density(n);
  std::rotate(density.begin(), density.begin() + 1, density.end());
  return plain_rule(sample(two_to_one, n, Side::fluid_inside), density, targets);
}

using Rule = ComplexVector (*)(Index, const ComplexVector&);

Measure errors_at_height(double height, Rule evaluate) {
  return errors_at(height, [=](Index n) {
    const ComplexVector targets = points_at(two_to_one, height);
    return relative_error(evaluate(n, targets), far_flow.velocity(targets));
  });
}

Line height_line(const std::string& key, const std::string& id, double height,
                 const std::string& defect, Rule defective) {
  const std::string text = std::to_string(height).substr(0, 3);
  return {
      .key = key,
      .label = "preimages at distance " + text,
      .measure = errors_at_height(height, rule),
      .claim = Claim{.id = id,
                     .statement = "Off the curve the rule converges as N e^{-d N}, d = " + text +
                                  " the distance of the target's preimage from the real "
                                  "axis.",
                     .law = Geometric{height, 0.03, 1.0},
                     .window = {.from = 4.0 / height, .floor = 1e-14},
                     .reason = "the kernel has a double pole in t where conj x(t) = conj z",
                     .api = {"stokesbook::StressletSum", "stokesbook::stresslet"}},
      .control = Control{defect, errors_at_height(height, defective)}};
}

/// Returns a density that is an entire function of the parameter.
Complex smooth_density(double t) {
  return {std::cos(t) + 0.3 * std::sin(3.0 * t), std::exp(std::sin(t)) - 0.5};
}

ComplexVector smooth_densities(Index n) {
  return ComplexVector::NullaryExpr(n, [n](Index j) {
    return smooth_density(2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
  });
}

/// Returns targets in the fluid at a distance in local spacings, at sixteen places between the
/// nodes.
ComplexVector targets_off(const Curve& curve, double spacings) {
  const TrigonometricPolynomial position(curve.x);
  return ComplexVector::NullaryExpr(16, [&](Index k) {
    const auto at = position(0.4 * static_cast<double>(k) + 0.13);
    return at.value + spacings * curve.sign() * imaginary * at.first * 2.0 * std::numbers::pi /
                          static_cast<double>(curve.size());
  });
}

/// Measures errors by distance. The exact values are computed by a rule that is so fine that no
/// target is near. The number of nodes is so large that five spacings are small relative to the
/// radius of curvature. Equal weights of all nodes are a planted defect.
Measure errors_over_spacings(const Shape& shape, Index n, Side side, bool equal_weights = false) {
  return [=](Size size) {
    const Curve curve = sample(shape, n, side), fine = sample(shape, 16 * n, side);
    const int steps = size == Size::full ? 20 : 10;
    ComplexVector density = smooth_densities(n);
    if (equal_weights) density = test::with_equal_weights(curve, density);
    std::vector<Measurement> measurements;
    for (int k = 1; k <= steps; ++k) {
      const double distance = 5.0 * k / steps;
      const ComplexVector targets = targets_off(curve, distance);
      const ComplexVector exact = plain_rule(fine, smooth_densities(fine.size()), targets);
      const ComplexVector got = plain_rule(curve, density, targets);
      measurements.push_back({.x = distance, .error = relative_error(got, exact)});
    }
    return measurements;
  };
}

Line spacing_line(const std::string& key, const std::string& id, const std::string& label,
                  const Shape& shape, Index n, Side side) {
  return {.key = key,
          .label = label,
          .measure = errors_over_spacings(shape, n, side),
          .claim = Claim{.id = id,
                         .statement = "Each spacing h between curve and target is worth a factor "
                                      "e^{-2 pi}, almost three digits.",
                         .law = Geometric{2.0 * std::numbers::pi, 0.03, 1.0},
                         .window = {.from = 0.7, .floor = 1e-14},
                         .reason = "close to a resolved curve d = |x - z| / |x'| and h = 2 pi |x'| "
                                   "/ N, so that d N = 2 pi |x - z| / h",
                         .api = {"stokesbook::StressletSum"}},
          .control =
              Control{"all nodes of the same weight", errors_over_spacings(shape, n, side, true)}};
}

}  // namespace

Experiment rates_near_the_curve() {
  return {
      .key = "rates",
      .title = "Convergence off the curve",
      .x = "nodes N",
      .error = "error of the velocity, relative to the largest",
      .axes = Axes::semi_log,
      .lines = {height_line("far", "02_3", 0.4, "the normal into the fluid", inward_normal),
                height_line("near", "02_4", 0.2, "all nodes of the same weight", same_weights),
                height_line("nearer", "02_5", 0.1, "densities of the next node", shifted_density)}};
}

Experiment spacings() {
  return {.key = "spacings",
          .title = "Error over the distance in spacings",
          .x = "distance in local spacings δ/h",
          .error = "error of the velocity, relative to the largest",
          .axes = Axes::semi_log,
          .lines = {spacing_line("wall", "02_6", "inside an ellipse 2:1, N = 3200", two_to_one,
                                 3200, Side::fluid_inside),
                    spacing_line("body", "02_7", "outside a star of 5 arms, N = 6400",
                                 Star{1.0, 0.2, 5}, 6400, Side::fluid_outside)}};
}

}  // namespace stokesbook::verification::double_layer
