// Tests the side test: counts wrong answers on resolved curves, and measures the distance of its
// boundary from the curve.
#include <algorithm>
#include <random>

#include "experiments.hpp"
#include "near_singular/barycentric.hpp"
#include "set_ups.hpp"
#include "support/over_nodes.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

/// Returns the sums for the side test of a curve (06.14).
using SumsOf = Barycentric (*)(Curve);

Barycentric right_sums(Curve curve) {
  return Barycentric(curve);
}
/// A planted defect: the curve has the opposite orientation.
Barycentric reversed(Curve curve) {
  curve.side = curve.side == Side::fluid_inside ? Side::fluid_outside : Side::fluid_inside;
  return Barycentric(curve);
}
/// A planted defect: a body's sum lacks the 1, like the sum of a wall that is traversed in the
/// opposite direction.
Barycentric without_one(Curve curve) {
  curve.dx *= -1.0;
  return reversed(curve);
}

/// Counts the wrong answers at 400 random points, half of them on either side.
int wrong_answers(const Curve& curve, const Shape& shape, double spacings, SumsOf sums_of) {
  const Barycentric sums = sums_of(curve);
  const Curve points = sample(shape, 10000, curve.side);
  const ComplexVector into_fluid = -normals(points);
  std::mt19937 generator(11);
  std::uniform_int_distribution<Index> anywhere(0, 9999);
  const double step = 2.0 * std::numbers::pi * spacings / static_cast<double>(curve.size());
  int wrong = 0;
  for (int i = 0; i < 400; ++i) {
    const Index j = anywhere(generator);
    const bool in_fluid = i % 2 == 0;
    const Complex height = step * std::abs(points.dx[j]) * into_fluid[j];
    const Complex z = points.x[j] + (in_fluid ? height : -height);
    if ((sums.side(z) > 0.5) != in_fluid) ++wrong;
  }
  return wrong;
}

Measure counts_of(const SetUp& set_up, SumsOf sums_of) {
  return [=](Size size) {
    const Curve curve = sample(set_up.shape, set_up.n, set_up.side);
    std::vector<double> distances{1e-11, 1e-9, 1e-7, 1e-5, 1e-3, 0.1, 3.0};
    if (size == Size::full) {
      distances.insert(distances.end(), {1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1.0});
      std::ranges::sort(distances);
    }
    std::vector<Measurement> measurements;
    for (const double d : distances) {
      measurements.push_back(
          {.x = d, .error = static_cast<double>(wrong_answers(curve, set_up.shape, d, sums_of))});
    }
    return measurements;
  };
}

SetUp with_nodes(SetUp set_up, Index n) {
  set_up.n = n;
  return set_up;
}

Line resolved_line(const std::string& key, const std::string& id, const std::string& label,
                   const SetUp& set_up, const Control& control) {
  return {.key = key,
          .label = label,
          .measure = counts_of(set_up, right_sums),
          .claim = Claim{.id = id,
                         .statement = "The side test never errs at " + label + ".",
                         .law = Identity{0.0},
                         .reason = "Re 1/(1 - q) > 1/2 for |q| < 1, q = e^{i N s} of the nearest "
                                   "preimage; all others are below rounding",
                         .api = {"stokesbook::CauchyCurve", "stokesbook::Barycentric"}},
          .control = control};
}

/// Returns the largest distance between the curve and the line on which Re Delta has the value of
/// the border, in local spacings.
double border_displacement(const Ellipse& shape, Index n, double border) {
  const Curve curve = sample(shape, n, Side::fluid_outside);
  const Barycentric sums(curve);
  const Curve points = sample(shape, 62, Side::fluid_outside);
  const ComplexVector into_fluid = -normals(points);
  double largest = 0.0;
  for (Index j = 0; j < points.size(); ++j) {
    const Complex spacing =
        2.0 * std::numbers::pi / static_cast<double>(n) * std::abs(points.dx[j]) * into_fluid[j];
    double below = -0.5, above = 0.5;
    for (int halvings = 0; halvings < 50; ++halvings) {
      const double middle = 0.5 * (below + above);
      (sums.side(points.x[j] + middle * spacing) > border ? above : below) = middle;
    }
    largest = std::max({largest, std::abs(below), std::abs(above)});
  }
  return largest;
}

Line border_line(const std::string& key, const std::string& id, const std::string& label,
                 const Ellipse& shape) {
  const double rate = std::log((shape.a + shape.b) / (shape.a - shape.b));
  const auto displacement = [=](double border) {
    const auto error = [=](Index n) { return border_displacement(shape, n, border); };
    return test::over_nodes(4.0, 32.0 / rate, 16, error, 1.0);
  };
  return {.key = key,
          .label = label,
          .measure = displacement(0.5),
          .claim = Claim{.id = id,
                         .statement = "At " + label +
                                      " the border of the side test approaches the "
                                      "curve as m^N, m = (a - b)/(a + b).",
                         .law = Geometric{rate, 0.05},
                         .window = {.from = 2.5 / rate, .floor = 1e-14},
                         .reason = "a point of the curve has its second preimage at the distance "
                                   "log(1/m)",
                         .api = {"stokesbook::CauchyCurve", "stokesbook::Barycentric"}},
          .control = Control{"0.4 in place of 1/2", displacement(0.4)}};
}

}  // namespace

Experiment sides() {
  return {
      .key = "sides",
      .title = "The side test at random points of both sides",
      .x = "distance in local spacings δ/h",
      .error = "wrong answers of 400",
      .lines = {resolved_line("ellipse", "06_25", "an ellipse 2:1, 128 nodes", ellipse,
                              {"a body's sum without its 1", counts_of(ellipse, without_one)}),
                resolved_line("star", "06_26", "a star of five arms, 400 nodes", star,
                              {"64 nodes", counts_of(with_nodes(star, 64), right_sums)}),
                resolved_line("slender", "06_27", "a container 10:1, 512 nodes", slender_container,
                              {"the other orientation", counts_of(slender_container, reversed)}),
                {.key = "coarse",
                 .label = "the star, 32 nodes",
                 .measure = counts_of(with_nodes(star, 32), right_sums)}}};
}

Experiment border() {
  return {.key = "border",
          .title = "The border of the side test",
          .x = "nodes N",
          .error = "largest distance from the curve, in local spacings",
          .axes = Axes::semi_log,
          .lines = {border_line("two", "06_28", "an ellipse 2:1", {1.0, 0.5}),
                    border_line("four", "06_29", "an ellipse 4:1", {1.0, 0.25})}};
}

}  // namespace stokesbook::verification::near_singular
