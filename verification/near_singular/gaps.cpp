// Tests the functions that measure distances: preimages of targets (06.4), and gaps between curves.
#include <algorithm>
#include <limits>

#include "experiments.hpp"
#include "near_singular/closest_points.hpp"
#include "near_singular/near_field.hpp"
#include "set_ups.hpp"
#include "support/smooth_curve.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

const Ellipse two_to_one{1.0, 0.5};

using Preimage = Complex (*)(const Curve&, Index, Complex);

/// A planted defect: the preimage consists of its first term only.
Complex linear(const Curve& curve, Index node, Complex target) {
  return (target - curve.x[node]) / curve.dx[node];
}

/// Returns the largest |x(t + s) - z|/|x'| of targets round five nodes.
double preimage_error(double distance, Preimage find) {
  const Curve curve = sample(two_to_one, 32, Side::fluid_outside);
  double error = 0.0;
  for (const Index node : {0, 3, 8, 13, 21}) {
    const Complex target = curve.x[node] + std::polar(distance, 1.0 + static_cast<double>(node));
    const Complex t =
        2.0 * std::numbers::pi * static_cast<double>(node) / 32.0 + find(curve, node, target);
    const Complex image = two_to_one.a * std::cos(t) + imaginary * two_to_one.b * std::sin(t);
    error = std::max(error, std::abs(image - target) / std::abs(curve.dx[node]));
  }
  return error;
}

Measure over_distance(Preimage find) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (double distance = 1e-3; distance < 2e-2; distance *= std::sqrt(2.0)) {
      measurements.push_back({.x = distance, .error = preimage_error(distance, find)});
    }
    return measurements;
  };
}

using Gap = double (*)(const SmoothCurve&, const SmoothCurve&);

double least_gap(const SmoothCurve& a, const SmoothCurve& b) {
  return closest_points(a, b).gap;
}
/// A planted defect: the gap is the least distance between nodes.
double between_nodes(const SmoothCurve& a, const SmoothCurve& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Complex x : a.nodes.x) {
    least = std::min(least, (b.nodes.x.array() - x).abs().minCoeff());
  }
  return least;
}

Measure over_gaps(Gap measured) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (double gap = 1e-8; gap < 2.0; gap *= 10.0) {
      double error = 0.0;
      for (const Complex direction : test::random_vector(20, 4)) {
        const Complex centre{0.3, -0.2};
        const SmoothCurve a = test::smooth_body(Circle{1.0}, 64, centre, 3.0 * direction.real()),
                          b = test::smooth_body(Circle{0.5}, 48,
                                                centre + std::polar(1.5 + gap, std::arg(direction)),
                                                3.0 * direction.imag());
        error = std::max(error, std::abs(measured(a, b) - gap));
      }
      measurements.push_back({.x = gap, .error = error});
    }
    return measurements;
  };
}

}  // namespace

Experiment preimage_order() {
  return {.key = "preimage",
          .title = "The preimage by a quadratic equation",
          .x = "distance of the target δ",
          .error = "distance of its image from the target, over |x'|",
          .lines = {{.key = "quadratic",
                     .label = "second order",
                     .measure = over_distance(preimage),
                     .claim = Claim{.id = "06_35",
                                    .statement = "The preimage of the near test is wrong by a "
                                                 "multiple of d^3.",
                                    .law = Algebraic{-3.0},
                                    .reason = "the curve's expansion is cut off after x''",
                                    .api = {"stokesbook::preimage"}},
                     .control = Control{"the first term alone", over_distance(linear)}}}};
}

Experiment gaps() {
  return {.key = "gaps",
          .title = "Gaps of two circles, turned at random",
          .x = "gap g",
          .error = "error of the gap",
          .lines = {{.key = "newton",
                     .label = "closest points",
                     .measure = over_gaps(least_gap),
                     .claim = Claim{.id = "06_36",
                                    .statement = "Gaps of circles are exact to the rounding of "
                                                 "their positions, wherever the nodes are.",
                                    .law = Identity{1e-14},
                                    .reason = "positions of the size 2 are rounded to 4e-16, and "
                                              "heights over the curve are regular at contact",
                                    .api = {"stokesbook::closest_points"}},
                     .control = Control{"the nearest nodes", over_gaps(between_nodes)}}}};
}

}  // namespace stokesbook::verification::near_singular
