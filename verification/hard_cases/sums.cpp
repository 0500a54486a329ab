// Compares fast sums with the direct sum, for nodes that may be difficult for a tree.
#include <cmath>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "hard_case.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

namespace {

Finding sum(const std::vector<Curve>& curves, double tolerance, const FmmSettings& settings) {
  const StressletSum direct(curves);
  Eigen::Index nodes = 0;
  for (const Curve& curve : curves) nodes += curve.size();
  const ComplexVector density = random_vector(nodes, 3);
  const Fmm fast(curves, ComplexVector(), settings);
  return {.tolerance = tolerance, .error = relative_error(fast.velocity(density), direct(density))};
}

Finding sum(const std::vector<Curve>& curves, double tolerance) {
  return sum(curves, tolerance, FmmSettings::for_tolerance(tolerance));
}

// The errors of points at one place add up. The order p is therefore the least order for which
// p 2^-p meets the tolerance, see FmmSettings::for_tolerance().
Finding coincident(const ComplexVector& points, double tolerance) {
  FmmSettings settings = FmmSettings::for_tolerance(tolerance);
  while (std::ldexp(settings.order, -settings.order) > tolerance) ++settings.order;
  return sum({cloud(points, 1e-3)}, tolerance, settings);
}

std::vector<Curve> crowds_apart() {
  const Curve small = sample(Ellipse{1e-8, 5e-9}, 32, Side::fluid_outside);
  std::vector<Curve> curves;
  for (int k = 0; k < 100; ++k) {
    const Complex position{3e-8 * (k % 10), 3e-8 * (k / 10)};
    curves.push_back(place(small, position, 0.1 * k));
    curves.push_back(place(small, position + 0.3, 0.2 * k));
  }
  return curves;
}

}  // namespace

std::vector<HardCase> sums() {
  constexpr Eigen::Index n = 5000;
  const auto over_points = [](const std::string& asked, const ComplexVector& points) {
    return HardCase{"08", "fast sum over " + asked,
                    [=] { return sum({cloud(points, 1e-3)}, 1e-9); }};
  };
  return {
      {"08", "fast sum over two crowds a million times as far apart as they are wide",
       [] { return sum(crowds_apart(), 1e-9); }},
      over_points("points that crowd towards one, over eight decades", crowding_points(n)),
      {"08", "fast sum over points of which three quarters are at one place, by the order for that",
       [] { return coincident(coincident_points(n), 1e-9); }},
      over_points("points on a line", points_on_a_line(n)),
      over_points("two clusters ten thousand times as far apart as they are wide", two_clusters(n)),
      {"08", "fast sum over one ellipse a thousand times as long as wide", [] {
         return sum({sample(Ellipse{1.0, 1e-3}, 4096, Side::fluid_outside)}, 1e-9);
       }}};
}

}  // namespace stokesbook::verification::hard_cases
