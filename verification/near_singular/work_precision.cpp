// Compares error and work of the schemes at targets near a curve.
#include <algorithm>
#include <chrono>
#include <limits>

#include "adaptive.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "near_singular/interpolation.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

/// The distances are in spacings, and all of them are below one.
constexpr std::array distances{1e-8, 1e-4, 1e-2, 0.1, 0.3, 0.5, 0.9};

/// Returns 61 points at each of these distances.
ComplexVector close_points(const Solved& solved) {
  ComplexVector points(0);
  for (const double d : distances) {
    const ComplexVector more = solved.points_at(d)(Eigen::seq(0, Eigen::last, 2));
    points.conservativeResize(points.size() + more.size());
    points.tail(more.size()) = more;
  }
  return points;
}

/// Returns a row of the table: the error, and the least time of three runs, of a function that
/// evaluates velocities at points.
template <class Evaluate>
Measurement row(const Solved& solved, const ComplexVector& points, double evaluations_a_target,
                const Evaluate& evaluate) {
  using Clock = std::chrono::steady_clock;
  ComplexVector velocity;
  double seconds = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 3; ++repeat) {
    const Clock::time_point start = Clock::now();
    velocity = evaluate(points);
    seconds = std::min(seconds, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return {.x = static_cast<double>(solved.curve.size()),
          .error = solved.error(velocity, points),
          .operations = evaluations_a_target,
          .seconds = seconds / static_cast<double>(points.size())};
}

/// Returns the flow's density on n nodes. If n is larger than 128, the density is interpolated from
/// 128 nodes, which resolve it.
Solved solved_on(Index n) {
  if (n > 128) return solved_ellipse().on_nodes(n);
  SetUp set_up = ellipse;
  set_up.n = n;
  return Solved(set_up);
}

template <class Method>
Measure over_nodes(const Method& method, Index most) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double n = 32.0; n <= static_cast<double>(most);
         n *= size == Size::full ? std::sqrt(2.0) : 2.0) {
      measurements.push_back(method(solved_on(2 * std::lround(0.5 * n))));
    }
    return measurements;
  };
}

Measurement plain_row(const Solved& solved) {
  const StressletSum sum({solved.curve});
  return row(solved, close_points(solved), static_cast<double>(solved.curve.size()),
             [&](const ComplexVector& points) { return sum(points, solved.density); });
}

Measurement cauchy_row(const Solved& solved) {
  const CauchyCurve curve(solved.curve);
  const CauchyData data = curve.data(solved.density);
  return row(solved, close_points(solved), static_cast<double>(solved.curve.size()),
             [&](const ComplexVector& points) { return curve.velocity(data, 0, points); });
}

Measurement interpolation(const Solved& solved, const InterpolationSettings& settings) {
  const InterpolationCurve curve(solved.curve, settings);
  const InterpolationData data = curve.data(solved.density);
  const double evaluations = static_cast<double>(settings.degree * settings.upsampling) *
                             static_cast<double>(solved.curve.size());
  return row(solved, close_points(solved), evaluations,
             [&](const ComplexVector& points) { return curve.velocity(data, 0, points); });
}

Measurement published(const Solved& solved) {
  return interpolation(solved, InterpolationSettings::published(solved.curve.size()));
}
/// A planted defect: the upsampling is that for 128 nodes at all n.
Measurement fixed_upsampling(const Solved& solved) {
  return interpolation(solved, InterpolationSettings::published(128));
}
Measurement for_six_digits(const Solved& solved) {
  return interpolation(solved, InterpolationSettings::for_tolerance(1e-6));
}
Measurement for_ten_digits(const Solved& solved) {
  return interpolation(solved, InterpolationSettings::for_tolerance(1e-10));
}

/// Measures at two points for each distance, because each point takes thousands of evaluations.
Measurement adaptive_row(const Solved& solved) {
  const ComplexVector points = close_points(solved)(Eigen::seqN(3, 14, 30)).eval();
  Index evaluations = 0;
  Measurement result = row(solved, points, 0.0, [&](const ComplexVector& z) -> ComplexVector {
    evaluations = 0;
    return z.unaryExpr([&](Complex target) {
      const AdaptiveResult found = adaptive_velocity(solved.curve, solved.density, target, 1e-10);
      evaluations += found.evaluations;
      return found.velocity;
    });
  });
  result.operations = static_cast<double>(evaluations) / static_cast<double>(points.size());
  return result;
}

}  // namespace

Experiment work_precision() {
  return {
      .key = "work",
      .title = "Targets closer than a spacing, by all methods",
      .x = "nodes N",
      .error = "worst error of the velocity closer than a spacing, relative",
      .lines = {{.key = "plain", .label = "trapezoid rule", .measure = over_nodes(plain_row, 512)},
                {.key = "published",
                 .label = "interpolation, published parameters",
                 .measure = over_nodes(published, 512),
                 .claim = Claim{.id = "06_34",
                                .statement = "With the published parameters a target takes a "
                                             "multiple of N^{3/2} kernel evaluations.",
                                .law = Cost{1.5, 0.1},
                                .reason = "six points, each with N ceil(sqrt N) fine nodes",
                                .api = {"stokesbook::InterpolationSettings"}},
                 .control = Control{"the upsampling of 128 nodes for all",
                                    over_nodes(fixed_upsampling, 512)}},
                {.key = "tolerance",
                 .label = "interpolation for 1e-6",
                 .measure = over_nodes(for_six_digits, 512)},
                {.key = "best",
                 .label = "interpolation for 1e-10",
                 .measure = over_nodes(for_ten_digits, 512)},
                {.key = "cauchy",
                 .label = "Cauchy integrals",
                 .measure = over_nodes(cauchy_row, 512)},
                {.key = "adaptive",
                 .label = "adaptive quadrature for 1e-10",
                 .measure = over_nodes(adaptive_row, 128)}},
      .work_precision = true,
      .operation = "kernel evaluations a target"};
}

}  // namespace stokesbook::verification::near_singular
