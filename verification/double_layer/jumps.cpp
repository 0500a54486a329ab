// Extrapolates the limits (02.8) of the double layer on the curve from values off the curve, from
// both sides.
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

ComplexVector densities(Index n) {
  return ComplexVector::NullaryExpr(n, [n](Index j) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    return Complex{std::cos(t) + 0.3 * std::sin(3.0 * t), std::exp(std::sin(t)) - 0.5};
  });
}

/// The limits are taken at these parameters, which lie between the nodes, without symmetry.
const Eigen::VectorXd parameters = Eigen::VectorXd::LinSpaced(8, 0.13, 5.9);

ComplexVector at_parameters(const ComplexVector& node_values) {
  const TrigonometricPolynomial polynomial(node_values);
  return parameters.unaryExpr([&](double t) { return polynomial(t).value; });
}

/// Returns the predicted limit, jump * eta + D eta.
ComplexVector limits(const Shape& shape, Side side, double jump) {
  constexpr Index n = 256;
  const Curve curve = sample(shape, n, side);
  const ComplexVector density = densities(n);
  const Eigen::VectorXd principal_value = double_layer_matrix(curve) * interleaved(density);
  return at_parameters(jump * density + deinterleaved(principal_value));
}

/// Selects the side from which a limit is approached.
enum class Approach { from_the_fluid = -1, from_the_other_side = +1 };

/// Returns D eta at a distance from the curve, by a rule that is so fine that the targets are not
/// near.
ComplexVector layer_at(const Shape& shape, Side side, Approach approach, double distance) {
  const Index nodes = 2 * static_cast<Index>(std::lround(40.0 / distance));
  const Curve coarse = sample(shape, 256, side), fine = sample(shape, nodes, side);
  const ComplexVector targets = at_parameters(coarse.x) + static_cast<double>(approach) * distance *
                                                              at_parameters(normals(coarse));
  return StressletSum({fine})(targets, densities(nodes));
}

Measure plain_approach(const Shape& shape, Side side, Approach approach, double jump) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const ComplexVector limit = limits(shape, side, jump);
    for (int m = 64; m <= (size == Size::full ? 4096 : 1024); m *= 2) {
      measurements.push_back(
          {.x = static_cast<double>(m),
           .error = relative_error(layer_at(shape, side, approach, 1.0 / m), limit)});
    }
    return measurements;
  };
}

/// Extrapolates to the curve by the parabola through values at one, two and three times the
/// distance.
Measure extrapolated(const Shape& shape, Side side, Approach approach, double jump) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const ComplexVector limit = limits(shape, side, jump);
    for (int m = 64; m <= (size == Size::full ? 4096 : 1024); m *= 2) {
      const double distance = 1.0 / m;
      const ComplexVector value = 3.0 * layer_at(shape, side, approach, distance) -
                                  3.0 * layer_at(shape, side, approach, 2.0 * distance) +
                                  layer_at(shape, side, approach, 3.0 * distance);
      measurements.push_back({.x = static_cast<double>(m), .error = relative_error(value, limit)});
    }
    return measurements;
  };
}

Line limit_line(const std::string& key, const std::string& id, const std::string& label,
                const Shape& shape, Side side, Approach approach) {
  const double jump = 0.5 * static_cast<double>(approach);
  const std::string sign = approach == Approach::from_the_fluid ? "-" : "+";
  return {
      .key = key,
      .label = label,
      .measure = extrapolated(shape, side, approach, jump),
      .claim = Claim{.id = id,
                     .statement = "The limit is " + sign + "eta/2 + D eta, " + label + ".",
                     .law = Algebraic{3.0, 0.1},
                     .window = {.from = 128.0, .floor = 1e-14},
                     .reason = "the small circle about the point on the curve; a parabola "
                               "through three values off the curve errs with order 3",
                     .api = {"stokesbook::double_layer_matrix"}},
      .control = Control{"the jump of the other side", extrapolated(shape, side, approach, -jump)}};
}

}  // namespace

Experiment jumps() {
  const Shape body = Star{1.0, 0.15, 3}, wall = Ellipse{2.0, 1.0};
  using enum Approach;
  return {.key = "jumps",
          .title = "The jump of the double layer",
          .x = "inverse distance (1/δ)",
          .error = "error of the limit, relative to its largest value",
          .lines = {{.key = "plain",
                     .label = "star from the fluid, without extrapolation",
                     .measure = plain_approach(body, Side::fluid_outside, from_the_fluid, -0.5)},
                    limit_line("fluid", "02_8", "on a star from the fluid outside", body,
                               Side::fluid_outside, from_the_fluid),
                    limit_line("inside", "02_9", "on a star from inside", body, Side::fluid_outside,
                               from_the_other_side),
                    limit_line("wall", "02_10", "on an ellipse from the fluid inside", wall,
                               Side::fluid_inside, from_the_fluid)}};
}

}  // namespace stokesbook::verification::double_layer
