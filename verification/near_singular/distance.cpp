// Measures the errors of velocities at distances from three spacings down to rounding.
#include <algorithm>

#include "adaptive.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "near_singular/interpolation.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

std::vector<double> distances_in_spacings(Size size) {
  std::vector<double> distances{1e-10, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.03,
                                0.1,   0.3,  0.5,  1.0,  2.0,  3.0};
  if (size == Size::full) {
    distances.insert(distances.end(), {1e-9, 1e-7, 1e-5, 0.2, 0.7, 1.5, 2.5});
    std::ranges::sort(distances);
  }
  return distances;
}

/// Measures the errors of a method by the distance. For a solved set-up, `method` returns a
/// function that evaluates velocities at points.
template <class Method>
Measure errors_over_distance(const SetUp& set_up, const Method& method) {
  return [=](Size size) {
    const Solved solved(set_up);
    const auto velocity = method(solved);
    std::vector<Measurement> measurements;
    for (const double d : distances_in_spacings(size)) {
      const ComplexVector points = solved.points_at(d);
      measurements.push_back({.x = d, .error = solved.error(velocity(points), points)});
    }
    return measurements;
  };
}

auto by_plain_rule(const Solved& solved) {
  return [&solved, sum = StressletSum({solved.curve})](const ComplexVector& points) {
    return sum(points, solved.density);
  };
}

auto by_cauchy(const Solved& solved) {
  const CauchyCurve curve(solved.curve);
  return [curve, data = curve.data(solved.density)](const ComplexVector& points) {
    return curve.velocity(data, 0, points);
  };
}

/// A planted defect: the weights have another divisor (06.14).
auto cauchy_divided_by(Divisor divisor) {
  return [divisor](const Solved& solved) {
    return [&solved, divisor,
            data = CauchyCurve(solved.curve).data(solved.density)](const ComplexVector& points) {
      return divided_by(divisor, solved.curve, data, points);
    };
  };
}

/// Returns the divisor of an enclosing wall; on a body the sum of the weights is 0, not 1.
Complex without_one(Complex sum) {
  return sum;
}
/// Returns the divisor 1, as if the rule for the constant 1 had no error.
Complex uncompensated(Complex) {
  return 1.0;
}
/// Returns the divisor of a body.
Complex with_one(Complex sum) {
  return 1.0 + sum;
}

auto interpolation(const InterpolationSettings& settings) {
  return [settings](const Solved& solved) {
    const InterpolationCurve curve(solved.curve, settings);
    return [curve, data = curve.data(solved.density)](const ComplexVector& points) {
      return curve.velocity(data, 0, points);
    };
  };
}

/// A planted defect: the values on the curve lack the jump.
auto published_without_jump(const Solved& solved) {
  const InterpolationCurve curve(solved.curve, InterpolationSettings::published(solved.set_up.n));
  InterpolationData data = curve.data(solved.density);
  const Eigen::VectorXd layer = double_layer_matrix(solved.curve) * interleaved(solved.density);
  data.limit = {TrigonometricPolynomial(deinterleaved(layer))};
  return [curve, data](const ComplexVector& points) { return curve.velocity(data, 0, points); };
}

/// Returns four of the points at a distance, because each point takes thousands of evaluations.
ComplexVector few_points(const Solved& solved, double spacings) {
  return solved.points_at(spacings)(Eigen::seqN(3, 4, 31));
}

ComplexVector right_density(ComplexVector density) {
  return density;
}
/// A planted defect: each node has the density of the next node.
ComplexVector shifted(ComplexVector density) {
  std::rotate(density.begin(), density.begin() + 1, density.end());
  return density;
}

Measure adaptive(ComplexVector (*density_of)(ComplexVector)) {
  return [=](Size size) {
    const Solved& solved = solved_ellipse();
    const ComplexVector density = density_of(solved.density);
    std::vector<Measurement> measurements;
    for (const double d : distances_in_spacings(size)) {
      const ComplexVector points = few_points(solved, d);
      const ComplexVector velocity = points.unaryExpr(
          [&](Complex z) { return adaptive_velocity(solved.curve, density, z, 1e-10).velocity; });
      measurements.push_back({.x = d, .error = solved.error(velocity, points)});
    }
    return measurements;
  };
}

/// Measures the share of points at which the quadrature reports success although its error exceeds
/// one per cent.
Measure false_successes(double tolerance) {
  return [=](Size size) {
    const Solved& solved = solved_ellipse();
    std::vector<double> distances{1e-10, 3e-10, 1e-9, 1e-7, 1e-5, 1e-3};
    if (size == Size::full) {
      distances.insert(distances.end(), {1e-8, 1e-6, 1e-4, 1e-2, 0.1, 1.0});
      std::ranges::sort(distances);
    }
    std::vector<Measurement> measurements;
    for (const double d : distances) {
      const ComplexVector points = few_points(solved, d);
      const auto is_false_success = [&](Complex z) {
        const AdaptiveResult found = adaptive_velocity(solved.curve, solved.density, z, tolerance);
        const double error = std::abs(found.velocity - solved.set_up.flow.velocity(z));
        return found.content && error > 0.01 * solved.scale;
      };
      const auto count = std::ranges::count_if(points, is_false_success);
      measurements.push_back(
          {.x = d, .error = static_cast<double>(count) / static_cast<double>(points.size())});
    }
    return measurements;
  };
}

Claim exact_at_any_distance(const std::string& id, const std::string& what) {
  return {.id = id,
          .statement = "The Cauchy scheme is exact to 1e-12 at every distance from " + what + ".",
          .law = Identity{1e-12},
          .reason =
              "numerator and divisor have the same error next to the curve; a sum of N terms "
              "rounds to some 10 N units of 1e-16",
          .api = {"stokesbook::CauchyCurve", "stokesbook::Barycentric"}};
}

Line shape_line(const std::string& key, const std::string& id, const std::string& label,
                const SetUp& set_up, const std::string& defect, Divisor divisor) {
  return {.key = key,
          .label = label,
          .measure = errors_over_distance(set_up, by_cauchy),
          .claim = exact_at_any_distance(id, label),
          .control = Control{defect, errors_over_distance(set_up, cauchy_divided_by(divisor))}};
}

}  // namespace

Experiment distances() {
  const auto published = InterpolationSettings::published(ellipse.n);
  const auto six = InterpolationSettings::for_tolerance(1e-6);
  const auto ten = InterpolationSettings::for_tolerance(1e-10);
  return {
      .key = "distance",
      .title = "Outside an ellipse 2:1, 128 nodes",
      .x = "distance in local spacings δ/h",
      .error = "error of the velocity, relative to the largest on the curve",
      .lines = {{.key = "plain",
                 .label = "trapezoid rule",
                 .measure = errors_over_distance(ellipse, by_plain_rule)},
                {.key = "published",
                 .label = "interpolation, published parameters",
                 .measure = errors_over_distance(ellipse, interpolation(published)),
                 .claim = Claim{.id = "06_2",
                                .statement = "The error of interpolation is proportional to the "
                                             "distance, next to the curve.",
                                .law = Algebraic{-1.0, 0.1},
                                .window = {.to = 0.1, .floor = 5e-14},
                                .reason = "the value on the curve is exact, and the weights of all "
                                          "others vanish there as the distance",
                                .api = {"stokesbook::InterpolationCurve"}},
                 .control = Control{"values on the curve without their jump",
                                    errors_over_distance(ellipse, published_without_jump)}},
                {.key = "tolerance",
                 .label = "interpolation for 1e-6",
                 .measure = errors_over_distance(ellipse, interpolation(six))},
                {.key = "best",
                 .label = "interpolation for 1e-10",
                 .measure = errors_over_distance(ellipse, interpolation(ten))},
                {.key = "cauchy",
                 .label = "Cauchy integrals",
                 .measure = errors_over_distance(ellipse, by_cauchy),
                 .claim = exact_at_any_distance("06_1", "an ellipse 2:1"),
                 .control = Control{"the divisor of a body without its 1",
                                    errors_over_distance(ellipse, cauchy_divided_by(without_one))}},
                {.key = "adaptive",
                 .label = "adaptive quadrature for 1e-10",
                 .measure = adaptive(right_density),
                 .claim = Claim{.id = "06_3",
                                .statement = "Adaptive quadrature is a reference down to 1e-4 "
                                             "spacings.",
                                .law = Identity{1e-9},
                                .window = {.from = 1e-4},
                                .reason = "the tolerance is 1e-10; the distance itself is rounded "
                                          "to 1e-16/d, d = 5e-6",
                                .api = {"stokesbook::stresslet"}},
                 .control = Control{"densities of the next node", adaptive(shifted)}}}};
}

Experiment false_successes() {
  return {
      .key = "silent",
      .title = "Adaptive quadrature that reports success and is wrong",
      .x = "distance in local spacings δ/h",
      .error = "share of targets: success reported, error above a per cent",
      .lines = {
          {.key = "six",
           .label = "tolerance 1e-6",
           .measure = false_successes(1e-6),
           .claim = Claim{.id = "06_4",
                          .statement =
                              "A billionth of a spacing from the curve and closer, adaptive "
                              "quadrature for 1e-6 misses the kernel's peak, and reports success.",
                          .law = Floor{1.0, 1.1},
                          .window = {.to = 2e-9},
                          .reason = "the nearest of the first 21 points of half the "
                                    "curve is a seventh of a spacing from its end, "
                                    "where the kernel is smooth and small",
                          .api = {"stokesbook::stresslet"}},
           .control = Control{"tolerance 1e-10", false_successes(1e-10)}},
          {.key = "ten", .label = "tolerance 1e-10", .measure = false_successes(1e-10)}}};
}

Experiment shapes() {
  return {
      .key = "shapes",
      .title = "The Cauchy scheme at other curves",
      .x = "distance in local spacings δ/h",
      .error = "error of the velocity, relative to the largest on the curve",
      .lines = {shape_line("star", "06_5", "a star of five arms, 400 nodes", star,
                           "weights that are not divided by their sum", uncompensated),
                shape_line("slender", "06_6", "the inside of an ellipse 10:1, 512 nodes",
                           slender_container, "the divisor of a body", with_one),
                shape_line("circle", "06_7", "the inside of a circle, 96 nodes", round_container,
                           "weights that are not divided by their sum", uncompensated)}};
}

}  // namespace stokesbook::verification::near_singular
