// Measures errors of derivatives at any distance from the surface: by Cauchy integrals, by the
// trapezoid rule, and by differences of velocities.
#include <algorithm>

#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "support/plain_rule.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::stress {

using namespace study;
using Eigen::Index;
using test::ExactFlow;
using test::inner_poles;
using test::outer_poles;

namespace {

/// Describes a curve whose nodes resolve the density of an exact flow to rounding.
struct Case {
  Shape shape;
  Side side;
  Index n;
  ExactFlow flow;
};

const Case ellipse_128{Ellipse{1.0, 0.5}, Side::fluid_outside, 128, inner_poles};
const Case star_400{Star{1.0, 0.2, 5}, Side::fluid_outside, 400, inner_poles};
const Case container_96{Circle{1.0}, Side::fluid_inside, 96, outer_poles};

struct Solved {
  explicit Solved(const Case& c)
      : curve(sample(c.shape, c.n, c.side)),
        density(test::density_of(curve, c.flow.velocity(curve.x))),
        cauchy(curve),
        data(cauchy.data(density)) {}

  Curve curve;
  ComplexVector density;
  CauchyCurve cauchy;
  CauchyData data;
};

using DerivativesMethod = std::vector<FlowDerivatives> (*)(const Solved&, const ComplexVector&,
                                                           double);

std::vector<FlowDerivatives> by_cauchy(const Solved& solved, const ComplexVector& targets, double) {
  return solved.cauchy.derivatives(solved.cauchy.derivative_data(solved.data), 0, targets);
}

std::vector<FlowDerivatives> by_trapezoid(const Solved& solved, const ComplexVector& targets,
                                          double) {
  return StressletSum({solved.curve}).derivatives(targets, solved.density);
}

/// Computes central differences of the Cauchy scheme's velocity, with a step of half the distance.
std::vector<FlowDerivatives> by_differences(const Solved& solved, const ComplexVector& targets,
                                            double distance) {
  const double step = 0.5 * distance;
  const auto slope = [&](Complex direction) -> ComplexVector {
    const ComplexVector h = ComplexVector::Constant(targets.size(), step * direction);
    return (solved.cauchy.velocity(solved.data, 0, targets + h) -
            solved.cauchy.velocity(solved.data, 0, targets - h)) /
           (2.0 * step);
  };
  const ComplexVector along_1 = slope(1.0), along_2 = slope(imaginary);
  std::vector<FlowDerivatives> result(static_cast<std::size_t>(targets.size()));
  for (Index i = 0; i < targets.size(); ++i) {
    result[static_cast<std::size_t>(i)] = {0.0, along_1[i].imag() - along_2[i].real(),
                                           along_1[i] + imaginary * along_2[i]};
  }
  return result;
}

/// A planted defect: the strain lacks the part of the other Goursat function, which comes from the
/// derivative of the node values along the curve.
std::vector<FlowDerivatives> without_stress(const Solved& solved, const ComplexVector& targets,
                                            double) {
  CauchyDerivativeData data = solved.cauchy.derivative_data(solved.data);
  data.stress.setZero();
  return solved.cauchy.derivatives(data, 0, targets);
}

/// Returns the error of strain, vorticity and (if the method has it) pressure at 22 points between
/// the nodes, relative to the largest strain. The first point is the pressure's datum.
double error_at(const Case& c, const Solved& solved, double distance, DerivativesMethod method,
                bool with_pressure) {
  const Curve between = sample(c.shape, 22, c.side);
  const ComplexVector targets = place(between, 0.0, 0.0).x - distance * normals(between);
  const std::vector<FlowDerivatives> found = method(solved, targets, distance);
  double error = 0.0, size = 0.0;
  const double datum = found[0].pressure - c.flow.pressure(targets[0]);
  for (Index i = 0; i < targets.size(); ++i) {
    const FlowDerivatives& at = found[static_cast<std::size_t>(i)];
    const FlowDerivatives exact = test::derivatives_of(c.flow, targets[i]);
    error = std::max(
        {error, std::abs(at.strain - exact.strain), std::abs(at.vorticity - exact.vorticity)});
    if (with_pressure) error = std::max(error, std::abs(at.pressure - exact.pressure - datum));
    size = std::max(size, std::abs(exact.strain));
  }
  return error / size;
}

Measure over_distances(const Case& c, DerivativesMethod method, bool with_pressure = true) {
  return [=, &c](Size size) {
    const Solved solved(c);
    const double step = size == Size::full ? 0.5 : 1.0;
    std::vector<Measurement> measurements;
    for (double power = -10.0; power <= -1.0; power += step) {
      const double distance = std::pow(10.0, power);
      measurements.push_back(
          {.x = distance, .error = error_at(c, solved, distance, method, with_pressure)});
    }
    return measurements;
  };
}

Line distance_line(const std::string& key, const std::string& id, const std::string& label,
                   const Case& c, const std::string& defect, DerivativesMethod defective) {
  return {.key = key,
          .label = label,
          .measure = over_distances(c, by_cauchy),
          .claim = Claim{.id = id,
                         .statement = "The errors of pressure, vorticity and strain by Cauchy "
                                      "integrals are below 1e-10 at any distance.",
                         .law = Identity{1e-10},
                         .reason = "the weights of the barycentric formula add up to 1 whatever "
                                   "cancels in them; the rest is rounding times N, once a "
                                   "differentiation",
                         .api = {"stokesbook::CauchyCurve::derivatives",
                                 "stokesbook::near_derivative_corrections"}},
          .control = Control{defect, over_distances(c, defective)}};
}

/// Returns a density that is an entire function of the parameter.
ComplexVector smooth_densities(Index n) {
  return ComplexVector::NullaryExpr(n, [n](Index j) {
    const double t = 2.0 * pi * static_cast<double>(j) / static_cast<double>(n);
    return Complex{std::cos(t) + 0.3 * std::sin(3.0 * t), std::exp(std::sin(t)) - 0.5};
  });
}

/// Measures errors of the trapezoid rule by the distance in spacings. The exact values come from a
/// rule with such a small spacing that no target is near. Equal weights of all nodes are a planted
/// defect.
Measure errors_over_spacings(const Shape& shape, Index n, Side side, bool equal_weights = false) {
  return [=](Size size) {
    const Curve curve = sample(shape, n, side), fine = sample(shape, 16 * n, side);
    const TrigonometricPolynomial position(curve.x);
    const int steps = size == Size::full ? 20 : 10;
    ComplexVector density = smooth_densities(n);
    if (equal_weights) density = test::with_equal_weights(curve, density);
    std::vector<Measurement> measurements;
    for (int k = 1; k <= steps; ++k) {
      const double distance = 5.0 * k / steps;
      const ComplexVector targets = ComplexVector::NullaryExpr(8, [&](Index i) {
        const auto at = position(0.8 * static_cast<double>(i) + 0.13);
        return at.value +
               distance * curve.sign() * imaginary * at.first * 2.0 * pi / static_cast<double>(n);
      });
      const auto exact = StressletSum({fine}).derivatives(targets, smooth_densities(16 * n));
      const auto got = StressletSum({curve}).derivatives(targets, density);
      double error = 0.0, largest = 0.0;
      for (std::size_t i = 0; i < got.size(); ++i) {
        error = std::max(error, std::abs(got[i].strain - exact[i].strain));
        largest = std::max(largest, std::abs(exact[i].strain));
      }
      measurements.push_back({.x = distance, .error = error / largest});
    }
    return measurements;
  };
}

}  // namespace

Experiment distances() {
  return {
      .key = "distance",
      .title = "Derivatives of the flow next to a boundary",
      .x = "distance d",
      .error = "largest error, relative to the largest strain",
      .axes = Axes::log_log,
      .lines = {
          distance_line("ellipse", "07_9", "Cauchy, ellipse 2:1, N = 128", ellipse_128,
                        "the trapezoid rule", by_trapezoid),
          distance_line("star", "07_10", "Cauchy, star, N = 400", star_400,
                        "the strain without psi'", without_stress),
          distance_line("container", "07_11", "Cauchy, circular container, N = 96", container_96,
                        "the trapezoid rule", by_trapezoid),
          {.key = "differences",
           .label = "differences of the velocity, ellipse",
           .measure = over_distances(ellipse_128, by_differences, false),
           .claim = Claim{.id = "07_12",
                          .statement = "Differences of a velocity with the error e, over a step "
                                       "that fits between target and surface, err as e/d.",
                          .law = Algebraic{1.0, 0.15},
                          .window = {.to = 2e-6},
                          .reason = "rounding divided by the step",
                          .api = {"stokesbook::CauchyCurve::velocity"}},
           .control = Control{"Cauchy integrals", over_distances(ellipse_128, by_cauchy, false)}},
          {.key = "trapezoid",
           .label = "trapezoid rule, ellipse",
           .measure = over_distances(ellipse_128, by_trapezoid)}}};
}

Experiment spacings() {
  return {.key = "spacings",
          .title = "Strain by the trapezoid rule over the distance in spacings",
          .x = "distance in local spacings d/h",
          .error = "error of the strain, relative to the largest",
          .axes = Axes::semi_log,
          .lines = {
              {.key = "body",
               .label = "outside an ellipse 2:1, N = 3200",
               .measure = errors_over_spacings(Ellipse{1.0, 0.5}, 3200, Side::fluid_outside),
               .claim = Claim{.id = "07_13",
                              .statement = "Each spacing is worth a factor e^{-2 pi}, as for "
                                           "velocities; the error is N times as large.",
                              .law = Geometric{2.0 * pi, 0.03, 1.0},
                              .window = {.from = 0.7, .floor = 1e-11},
                              .reason = "the kernel's pole in t is of third order, N^2 d e^{-d N}, "
                                        "and d N = 2 pi d/h",
                              .api = {"stokesbook::StressletSum::derivatives"}},
               .control = Control{
                   "all nodes of the same weight",
                   errors_over_spacings(Ellipse{1.0, 0.5}, 3200, Side::fluid_outside, true)}}}};
}

}  // namespace stokesbook::verification::stress
