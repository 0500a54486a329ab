// Computes the rate of strain on a body's surface by Cauchy integrals and by simpler methods: sums
// of the hypersingular kernel, extrapolation, differences.
#include <algorithm>
#include <chrono>

#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::stress {

using namespace study;
using Eigen::Index;

namespace {

constexpr double pole_depth = 0.4;  // depth of the nearest pole, in the parameter
const Ellipse body_ellipse{1.0, 0.5};
const test::ExactFlow pole_flow{
    {{point_at_depth(body_ellipse, pole_depth, 0.8), {0.05, -0.03}, 0.04},
     {point_at_depth(body_ellipse, 0.5, 3.9), {0.02, 0.08}, -0.05}}};

constexpr Index target_count = 16;

/// Returns the flow's density, resolved on 208 nodes.
ComplexVector resolved_density(Index n) {
  static const ComplexVector density = [] {
    const Curve body = sample(body_ellipse, 208, Side::fluid_outside);
    return test::density_of(body, pole_flow.velocity(body.x));
  }();
  return resample(density, n);
}

/// Holds the strains at every (N / 16)-th node, and the number of kernel evaluations.
struct Evaluation {
  ComplexVector strain;
  Index kernels;
};

/// Evaluates the trapezoid sum of the hypersingular kernel without the target's own node.
Evaluation sum_over_others(const Curve& body, const ComplexVector& density, bool subtracts) {
  const Index n = body.size(), step = n / target_count;
  const ComplexVector normal = normals(body);
  const Eigen::VectorXd w = weights(body);
  ComplexVector strain = ComplexVector::Zero(target_count);
  for (Index i = 0; i < target_count; ++i) {
    for (Index j = 0; j < n; ++j) {
      if (j == i * step) continue;
      const Complex eta = density[j] - (subtracts ? density[i * step] : Complex{});
      strain[i] +=
          w[j] * stresslet_derivatives(body.x[i * step] - body.x[j], normal[j], eta).strain;
    }
  }
  return {strain, n * target_count};
}

Evaluation punctured(const Curve& body, const ComplexVector& density) {
  return sum_over_others(body, density, false);
}

/// A planted defect: the sum lacks the jump and converges to the mean of the limits from both
/// sides.
Evaluation without_jump(const Curve& body, const ComplexVector& density) {
  return sum_over_others(body, density, true);
}

/// Adds half of the jump (07.9), -(t.eta_s) t^2, to the sum.
Evaluation subtracted(const Curve& body, const ComplexVector& density) {
  Evaluation result = without_jump(body, density);
  const ComplexVector slope = differentiate(density);
  for (Index i = 0; i < target_count; ++i) {
    const Index node = i * body.size() / target_count;
    const Complex dx = body.dx[node];
    result.strain[i] -= dot(dx, slope[node]) * dx * dx / (std::norm(dx) * std::norm(dx));
  }
  return result;
}

/// Returns points in the fluid at a multiple of the local spacing from the targets.
ComplexVector lifted(const Curve& body, double spacings) {
  const Index step = body.size() / target_count;
  const ComplexVector normal = normals(body);
  const Eigen::VectorXd w = weights(body);
  return ComplexVector::NullaryExpr(target_count, [&](Index i) {
    return body.x[i * step] - spacings * w[i * step] * normal[i * step];
  });
}

/// Extrapolates to the surface by the parabola through the trapezoid rule's values at three
/// distances.
Evaluation extrapolated_from(double first, const Curve& body, const ComplexVector& density) {
  const StressletSum sum({body});
  ComplexVector strain = ComplexVector::Zero(target_count);
  for (int k = 0; k < 3; ++k) {
    double weight = 1.0;
    for (int m = 0; m < 3; ++m) {
      if (m != k) weight *= (first + m) / (m - k);
    }
    const auto values = sum.derivatives(lifted(body, first + k), density);
    for (Index i = 0; i < target_count; ++i) {
      strain[i] += weight * values[static_cast<std::size_t>(i)].strain;
    }
  }
  return {strain, 3 * body.size() * target_count};
}

Evaluation extrapolated(const Curve& body, const ComplexVector& density) {
  return extrapolated_from(6.0, body, density);
}

/// A planted defect: the values are so near to the surface that the trapezoid rule is wrong.
Evaluation extrapolated_too_near(const Curve& body, const ComplexVector& density) {
  return extrapolated_from(1.0, body, density);
}

/// Computes one-sided differences of second order of the Cauchy scheme's velocities along the
/// normal and the tangent: q = 2 du/d(conj z) (07.4).
Evaluation differences_of_step(double step, const Curve& body, const ComplexVector& density) {
  const CauchyCurve cauchy(body);
  const CauchyData data = cauchy.data(density);
  const ComplexVector surface = lifted(body, 0.0);
  const ComplexVector outward =
      (lifted(body, 1.0) - surface).array() / (lifted(body, 1.0) - surface).array().abs();
  const auto slope = [&](Complex turn) -> ComplexVector {
    const ComplexVector h = step * turn * outward;
    return (-3.0 * cauchy.velocity(data, 0, surface) + 4.0 * cauchy.velocity(data, 0, surface + h) -
            cauchy.velocity(data, 0, surface + 2.0 * h)) /
           (2.0 * step);
  };
  const ComplexVector strain = outward.cwiseProduct(slope(1.0) + imaginary * slope(imaginary));
  const Index n = body.size();
  return {strain, 3 * n * n + 6 * n * target_count};
}

Evaluation differences(const Curve& body, const ComplexVector& density) {
  return differences_of_step(2.0 * pi / static_cast<double>(body.size()), body, density);
}

/// A planted defect: the step does not decrease with the spacing.
Evaluation differences_of_fixed_step(const Curve& body, const ComplexVector& density) {
  return differences_of_step(0.05, body, density);
}

/// Computes the limit by Cauchy integrals. The limit requires N weights for each target, and three
/// matrices of the curve on itself.
Evaluation cauchy_limit(const Curve& body, const ComplexVector& density) {
  const CauchyCurve cauchy(body);
  const CauchyDerivativeData data = cauchy.derivative_data(cauchy.data(density));
  const auto values = cauchy.derivatives(data, 0, lifted(body, 0.0));
  const Index n = body.size();
  ComplexVector strain(target_count);
  std::ranges::transform(values, strain.begin(), &FlowDerivatives::strain);
  return {strain, 3 * n * n + n * target_count};
}

/// A planted defect: the limit is taken from the other side.
Evaluation limit_from_inside(const Curve& body, const ComplexVector& density) {
  Curve turned = body;
  turned.side = Side::fluid_inside;
  Evaluation inside = cauchy_limit(turned, density);
  inside.strain *= -1.0;
  return inside;
}

using StrainMethod = Evaluation (*)(const Curve&, const ComplexVector&);

Measure errors_of(StrainMethod method, const std::vector<Index>& counts) {
  return [=](Size) {
    using Clock = std::chrono::steady_clock;
    std::vector<Measurement> measurements;
    for (const Index n : counts) {
      const Curve body = sample(body_ellipse, n, Side::fluid_outside);
      const ComplexVector density = resolved_density(n), targets = lifted(body, 0.0);
      const Clock::time_point start = Clock::now();
      const Evaluation got = method(body, density);
      const std::chrono::duration<double> taken = Clock::now() - start;
      const ComplexVector exact = targets.unaryExpr([](Complex z) { return pole_flow.strain(z); });
      measurements.push_back({.x = static_cast<double>(n),
                              .error = test::largest(got.strain - exact) / test::largest(exact),
                              .operations = static_cast<double>(got.kernels),
                              .seconds = taken.count()});
    }
    return measurements;
  };
}

const std::vector<Index> many{64, 128, 256, 512, 1024, 2048},
    very_many{256, 512, 1024, 2048, 4096, 8192, 16384}, moderate{32, 64, 128, 256, 512},
    few{32, 48, 64, 80, 96, 112, 128, 144, 160};

/// Returns an error on the surface at points between the nodes. The density is the solution on the
/// nodes.
using Quantity = std::function<double(const CauchyCurve&, const CauchyData&, const ComplexVector&)>;

Measure between_nodes(const Quantity& error, Side side = Side::fluid_outside) {
  return test::over_nodes(
      16.0, 170.0, 16,
      [=](Index n) {
        const Curve body = sample(body_ellipse, n, Side::fluid_outside);
        const ComplexVector density = test::density_of(body, pole_flow.velocity(body.x));
        Curve seen = body;
        seen.side = side;
        const CauchyCurve cauchy(seen);
        const ComplexVector targets = ComplexVector::NullaryExpr(24, [](Index k) {
          const double t = 0.13 + 0.2613 * static_cast<double>(k);
          return Complex{body_ellipse.a * std::cos(t), body_ellipse.b * std::sin(t)};
        });
        return error(cauchy, cauchy.data((side == body.side ? 1.0 : -1.0) * density), targets);
      },
      2.0);
}

double velocity_error(const CauchyCurve& cauchy, const CauchyData& data,
                      const ComplexVector& targets) {
  const ComplexVector exact = pole_flow.velocity(targets);
  return test::largest(cauchy.velocity(data, 0, targets) - exact) / test::largest(exact);
}

/// Returns the largest error of a part of the derivatives, relative to its largest value. The other
/// sign of phi' is a planted defect.
template <class Part>
Quantity error_of(const Part& part, double sign = 1.0) {
  return [=](const CauchyCurve& cauchy, const CauchyData& data, const ComplexVector& targets) {
    CauchyDerivativeData derivative_data = cauchy.derivative_data(data);
    derivative_data.dphi *= sign;
    const auto found = cauchy.derivatives(derivative_data, 0, targets);
    double error = 0.0, size = 0.0;
    for (Index i = 0; i < targets.size(); ++i) {
      const Complex exact = part(derivatives_of(pole_flow, targets[i]));
      error = std::max(error, std::abs(part(found[static_cast<std::size_t>(i)]) - exact));
      size = std::max(size, std::abs(exact));
    }
    return error / size;
  };
}

Complex pressure(const FlowDerivatives& at) {
  return at.pressure;
}

Complex strain(const FlowDerivatives& at) {
  return at.strain;
}

const std::vector<std::string> cauchy_api{"stokesbook::CauchyCurve::derivatives",
                                          "stokesbook::SolvedFlow::derivatives"};

}  // namespace

Experiment methods_on_the_surface() {
  return {
      .key = "methods",
      .title = "The rate of strain on the surface, by five methods",
      .x = "nodes N",
      .error = "error of the rate of strain, relative to the largest",
      .axes = Axes::log_log,
      .lines =
          {{.key = "punctured",
            .label = "sum over all other nodes",
            .measure = errors_of(punctured, many),
            .claim = Claim{.id = "07_1",
                           .statement = "The sum of the hypersingular kernel over all other nodes "
                                        "diverges: its error grows as N.",
                           .law = Algebraic{-1.0, 0.05},
                           .window = {.from = 100.0},
                           .reason = "next to the target the kernel is like 1/s^2, of which the "
                                     "sum 2 h (1/h^2 + 1/(2h)^2 + ...) = pi^2 / (3 h) stays",
                           .api = {"stokesbook::stresslet_derivatives"}},
            .control = Control{"the density's own value subtracted", errors_of(subtracted, many)}},
           {.key = "subtracted",
            .label = "the same, density minus its own value",
            .measure = errors_of(subtracted, many),
            .claim = Claim{.id = "07_2",
                           .statement = "With the density's own value subtracted, and half the "
                                        "jump added, the sum is of first order.",
                           .law = Algebraic{1.0, 0.05},
                           .window = {.from = 200.0},
                           .reason = "the odd part 1/s cancels in the sum; what the target's own "
                                     "node should have added is h times a number",
                           .api = {"stokesbook::stresslet_derivatives"}},
            .control = Control{"without the jump", errors_of(without_jump, many)}},
           {.key = "differences",
            .label = "differences of velocities, step like h",
            .measure = errors_of(differences, moderate),
            .claim = Claim{.id = "07_3",
                           .statement = "One-sided differences of the velocity are of their own "
                                        "second order, however exact the velocity.",
                           .law = Algebraic{2.0, 0.15},
                           .window = {.from = 100.0},
                           .reason = "the step is proportional to 1/N",
                           .api = {"stokesbook::CauchyCurve::velocity"}},
            .control =
                Control{"a step that stays", errors_of(differences_of_fixed_step, moderate)}},
           {.key = "extrapolated",
            .label = "extrapolation from 6, 7 and 8 spacings",
            .measure = errors_of(extrapolated, very_many),
            .claim = Claim{.id = "07_4",
                           .statement = "Extrapolation by a parabola from where the trapezoid rule "
                                        "is exact to rounding is of third order.",
                           .law = Algebraic{3.0, 0.15},
                           .window = {.from = 2000.0},
                           .reason = "the distances are multiples of the spacing",
                           .api = {"stokesbook::StressletSum::derivatives"}},
            .control = Control{"extrapolation from 1, 2 and 3 spacings",
                               errors_of(extrapolated_too_near, very_many)}},
           {.key = "cauchy",
            .label = "Cauchy integrals",
            .measure = errors_of(cauchy_limit, few),
            .claim = Claim{.id = "07_5",
                           .statement = "The limit by Cauchy integrals converges as the density's "
                                        "modes fall, N^2 e^{-d N / 2}.",
                           .law = Geometric{0.5 * pole_depth, 0.05, 2.0},
                           .window = {.from = 40.0, .floor = 1e-13},
                           .reason = "the pole at depth d makes modes k e^{-d k}, of which N nodes "
                                     "hold those below N/2; the derivative has one more k",
                           .api = cauchy_api},
            .control =
                Control{"the limit from the other side", errors_of(limit_from_inside, few)}}},
      .work_precision = true,
      .operation = "kernel evaluations"};
}

Experiment rates_on_the_surface() {
  const auto claim = [](const std::string& id, const std::string& what, double power) {
    return Claim{.id = id,
                 .statement = "On the surface, between the nodes, " + what +
                              " converges at half the rate of the pole's depth d.",
                 .law = Geometric{0.5 * pole_depth, 0.05, power},
                 .window = {.from = 40.0, .floor = 1e-13},
                 .reason =
                     "the density's modes k e^{-d k} beyond N/2 are cut off, and aliases of "
                     "its highest ones are as large; a derivative has one more k",
                 .api = cauchy_api};
  };
  return {.key = "surface",
          .title = "Velocity, pressure and strain on the surface, between the nodes",
          .x = "nodes N",
          .error = "largest error, relative to the largest value",
          .axes = Axes::semi_log,
          .lines = {{.key = "velocity",
                     .label = "velocity",
                     .measure = between_nodes(velocity_error),
                     .claim = claim("07_6", "the velocity", 1.0),
                     .control = Control{"the limit from the other side",
                                        between_nodes(velocity_error, Side::fluid_inside)}},
                    {.key = "pressure",
                     .label = "pressure",
                     .measure = between_nodes(error_of(pressure)),
                     .claim = claim("07_7", "the pressure", 2.0),
                     .control = Control{"phi' with the sign of the published formula",
                                        between_nodes(error_of(pressure, -1.0))}},
                    {.key = "strain",
                     .label = "rate of strain",
                     .measure = between_nodes(error_of(strain)),
                     .claim = claim("07_8", "the rate of strain", 2.0),
                     .control = Control{"the limit from the other side",
                                        between_nodes(error_of(strain), Side::fluid_inside)}}}};
}

}  // namespace stokesbook::verification::stress
