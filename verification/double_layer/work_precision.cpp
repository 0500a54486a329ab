// Compares error and work at targets close to a wall: the plain rule, a finer rule for the same
// density, and the Cauchy scheme of chapter 06.
#include <algorithm>
#include <chrono>

#include "experiments.hpp"
#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

constexpr double height = 0.03;
constexpr Index refinement = 4;
const ComplexVector targets = points_at(two_to_one, height);

/// Holds velocities, and the number of kernel evaluations.
struct Evaluation {
  ComplexVector velocity;
  Index kernels;
};

Evaluation plain(const Curve& wall, const ComplexVector& density) {
  return {plain_rule(wall, density, targets), wall.size() * targets.size()};
}

/// A planted defect: the normal points into the fluid.
Evaluation inward_normal(const Curve& wall, const ComplexVector& density) {
  Curve turned = wall;
  turned.side = Side::fluid_outside;
  return plain(turned, density);
}

Evaluation refined(const Curve& wall, const ComplexVector& density) {
  const Index n = refinement * wall.size();
  return plain(sample(two_to_one, n, wall.side), resample(density, n));
}

/// A planted defect: each fine node takes the density of the preceding coarse node.
Evaluation refined_by_steps(const Curve& wall, const ComplexVector& density) {
  const Index n = refinement * wall.size();
  const ComplexVector steps =
      ComplexVector::NullaryExpr(n, [&](Index j) { return density[j / refinement]; });
  return plain(sample(two_to_one, n, wall.side), steps);
}

/// The Cauchy scheme takes N weights for each target, and three matrices of the curve on itself.
Evaluation cauchy(const Curve& wall, const ComplexVector& density) {
  const CauchyCurve curve(wall);
  const CauchyData data = curve.data(density);
  return {curve.velocity(data, 0, targets), wall.size() * (targets.size() + 3 * wall.size())};
}

/// Returns the density of the flow. If n is larger than 96, the density is interpolated from 96
/// nodes, which resolve it to rounding.
ComplexVector density_on(Index n) {
  const Curve wall = sample(two_to_one, std::min<Index>(n, 96), Side::fluid_inside);
  return resample(test::density_of(wall, far_flow.velocity(wall.x)), n);
}

using Method = Evaluation (*)(const Curve&, const ComplexVector&);

Measure errors_of(Method method, Index most_nodes) {
  return [=](Size size) {
    using Clock = std::chrono::steady_clock;
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? 1.25 : 1.5;
    for (double nodes = 16.0; nodes <= static_cast<double>(most_nodes); nodes *= factor) {
      const Index n = 2 * std::lround(0.5 * nodes);
      const Curve wall = sample(two_to_one, n, Side::fluid_inside);
      const ComplexVector density = density_on(n);
      const Clock::time_point start = Clock::now();
      const Evaluation got = method(wall, density);
      measurements.push_back(
          {.x = static_cast<double>(n),
           .error = relative_error(got.velocity, far_flow.velocity(targets)),
           .operations = static_cast<double>(got.kernels),
           .seconds = std::chrono::duration<double>(Clock::now() - start).count()});
    }
    return measurements;
  };
}

}  // namespace

Experiment near_target() {
  return {
      .key = "near",
      .title = "Sixteen targets close to a wall, by three methods",
      .x = "nodes N",
      .error = "error of the velocity, relative to the largest",
      .axes = Axes::semi_log,
      .lines = {{.key = "plain",
                 .label = "trapezoid rule",
                 .measure = errors_of(plain, 1400),
                 .claim = Claim{.id = "02_28",
                                .statement = "With preimages at the distance 0.03 the rule "
                                             "converges as N e^{-0.03 N}, though 60 nodes "
                                             "resolve the density.",
                                .law = Geometric{height, 0.03, 1.0},
                                .window = {.from = 130.0, .floor = 1e-14},
                                .reason = "the kernel's double pole in t",
                                .api = {"stokesbook::StressletSum"}},
                 .control = Control{"the normal into the fluid", errors_of(inward_normal, 1400)}},
                {.key = "refined",
                 .label = "rule of 4 N nodes, density interpolated",
                 .measure = errors_of(refined, 350),
                 .claim = Claim{.id = "02_29",
                                .statement = "A rule with four times the nodes has four times the "
                                             "rate: large errors are confined nearer to the wall.",
                                .law = Geometric{refinement * height, 0.03, 1.0},
                                .window = {.from = 33.0, .floor = 1e-14},
                                .reason = "4 N nodes, and the density is resolved",
                                .api = {"stokesbook::resample", "stokesbook::StressletSum"}},
                 .control = Control{"densities repeated, not interpolated",
                                    errors_of(refined_by_steps, 350)}},
                {.key = "cauchy",
                 .label = "Cauchy integrals (chapter 06)",
                 .measure = errors_of(cauchy, 200)}},
      .work_precision = true,
      .operation = "kernel evaluations"};
}

}  // namespace stokesbook::verification::double_layer
