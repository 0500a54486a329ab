// Computes stresslets of free ellipses (07.14), (07.15) and their mean over a Jeffery orbit.
#include <algorithm>

#include "experiments.hpp"
#include "stress/stress.hpp"
#include "stress/stresslet.hpp"
#include "support/dense.hpp"

namespace stokesbook::verification::stress {

using namespace study;
using Eigen::Index;

namespace {

const FlowDerivatives shear = flow_derivatives({.du1_dx2 = 1.0});

using StressletOf = Complex (*)(const Curve&, const ComplexVector&, double);

/// Represents a free ellipse alone, whose system is factorised once for all linear flows.
class FreeEllipse {
 public:
  FreeEllipse(double ratio, Index n)
      : problem_{{test::free_body(Ellipse{ratio, 1.0}, n, {})}, viscosity, {}, {}},
        inverse_(test::inverse(assemble(problem_, ClosureForm::reduced).matrix)) {}

  /// Returns the stresslet at an angle of the long axis in the shear flow.
  Complex stresslet(double angle, StressletOf stresslet_of = body_stresslet) const {
    const Complex turn = std::polar(1.0, 2.0 * angle);
    StokesProblem problem = problem_;
    const Curve& curve = problem.components[0].curve;
    problem.background = linear_velocity({0.0, shear.vorticity, shear.strain / turn}, curve.x);
    const Closure closure(problem);
    const ComplexVector rhs = closure.right_hand_side();
    const Eigen::VectorXd density = inverse_ * interleaved(rhs);
    return turn *
           stresslet_of(curve, closure.without_rigid_part(deinterleaved(density)), viscosity);
  }

  double area() const { return pi * ratio() * 1.0; }
  double ratio() const { return problem_.components[0].curve.x[0].real(); }

  double intrinsic_viscosity_at(double angle, StressletOf stresslet_of = body_stresslet) const {
    return intrinsic_viscosity(stresslet(angle, stresslet_of), shear.strain, area(), viscosity);
  }

 private:
  StokesProblem problem_;
  Eigen::MatrixXd inverse_;
};

/// Returns S' = (pi mu / 2) (a + b)^2 (Re q' + 2 i a b / (a^2 + b^2) Im q') in the ellipse's frame.
Complex exact_stresslet(double ratio, double angle) {
  const Complex turn = std::polar(1.0, 2.0 * angle), strain = shear.strain / turn;
  const double size = 0.5 * pi * viscosity * (ratio + 1.0) * (ratio + 1.0);
  return turn * size * Complex{strain.real(), 2.0 * ratio / (ratio * ratio + 1.0) * strain.imag()};
}

/// A planted defect: the normal points into the fluid.
Complex with_inward_normal(const Curve& curve, const ComplexVector& density, double mu) {
  Curve turned = curve;
  turned.side = Side::fluid_inside;
  return body_stresslet(turned, density, mu);
}

/// A planted defect: the scalar product replaces the complex product.
Complex with_scalar_product(const Curve& curve, const ComplexVector& density, double mu) {
  return -mu * normals(curve).conjugate().cwiseProduct(weights(curve)).cwiseProduct(density).sum();
}

/// Returns log(1 / m), m = (a - b) / (a + b). All errors of an ellipse decay as powers of m.
double rate_of(double ratio) {
  return std::log((ratio + 1.0) / (ratio - 1.0));
}

Measure stresslet_errors(double ratio, StressletOf stresslet_of) {
  const double rate = rate_of(ratio);
  return test::over_nodes(
      5.0 / rate, 36.0 / rate, 16,
      [=](Index n) {
        constexpr double angle = 0.5;
        const Complex exact = exact_stresslet(ratio, angle);
        return std::abs(FreeEllipse(ratio, n).stresslet(angle, stresslet_of) - exact) /
               std::abs(exact);
      },
      2.0);
}

Line stresslet_line(const std::string& key, const std::string& id, double ratio,
                    const std::string& defect, StressletOf defective) {
  const std::string text = std::to_string(std::lround(ratio)) + ":1";
  return {.key = key,
          .label = "ellipse " + text,
          .measure = stresslet_errors(ratio, body_stresslet),
          .claim = Claim{.id = id,
                         .statement = "The stresslet of a free ellipse converges as N m^N, "
                                      "m = (a - b)/(a + b).",
                         .law = Geometric{rate_of(ratio), 0.03, 1.0},
                         .window = {.from = 8.0 / rate_of(ratio), .floor = 1e-15},
                         .reason = "the density has the modes 1 and -1 only, the kernel's modes "
                                   "are k m^(k-1), and N nodes take N - 1 for -1",
                         .api = {"stokesbook::body_stresslet"}},
          .control = Control{defect, stresslet_errors(ratio, defective)}};
}

/// Returns the angle of the long axis at a phase of the Jeffery orbit. The phase is proportional to
/// time.
double orbit_angle(double ratio, double phase) {
  return std::atan2(-std::sin(phase), ratio * std::cos(phase));
}

/// A planted defect: the mean is over equally spaced angles instead of times.
double equal_angle(double, double phase) {
  return phase;
}

using Angle = double (*)(double, double);

/// Returns the mean over half a turn, after which the ellipse has the same shape.
double mean_viscosity(const FreeEllipse& ellipse, Index phases, Angle angle,
                      StressletOf stresslet_of = body_stresslet) {
  double sum = 0.0;
  for (Index j = 0; j < phases; ++j) {
    const double phase = pi * (static_cast<double>(j) + 0.3) / static_cast<double>(phases);
    sum += ellipse.intrinsic_viscosity_at(angle(ellipse.ratio(), phase), stresslet_of);
  }
  return sum / static_cast<double>(phases);
}

/// Returns an ellipse with nodes that resolve its density to rounding.
const FreeEllipse& resolved_ellipse(double ratio) {
  static Once<double, FreeEllipse> ellipses;
  return ellipses(ratio, [&] {
    const double nodes = ratio > 1.0 ? 2.0 * std::ceil(21.0 / rate_of(ratio)) : 32.0;
    return FreeEllipse(ratio, static_cast<Index>(nodes));
  });
}

Measure orbit_errors(double ratio, Angle angle) {
  return [=](Size size) {
    const FreeEllipse& ellipse = resolved_ellipse(ratio);
    const double rate = rate_of(ratio);
    const double step = std::max(1.0, (size == Size::full ? 1.5 : 3.0) / rate);
    std::vector<Measurement> measurements;
    for (double phases = 3.0 / rate; phases < 36.0 / rate; phases += step) {
      const auto m = static_cast<Index>(phases);
      measurements.push_back({.x = static_cast<double>(m),
                              .error = std::abs(0.5 * mean_viscosity(ellipse, m, angle) - 1.0)});
    }
    return measurements;
  };
}

Line orbit_line(const std::string& key, const std::string& id, double ratio) {
  return {.key = key,
          .label = "ellipse " + std::to_string(std::lround(ratio)) + ":1",
          .measure = orbit_errors(ratio, orbit_angle),
          .claim = Claim{.id = id,
                         .statement = "The mean of the intrinsic viscosity over equal times of "
                                      "half an orbit goes to 2 as M m^M.",
                         .law = Geometric{rate_of(ratio), 0.05, 1.0},
                         .window = {.from = 5.0 / rate_of(ratio), .floor = 1e-14},
                         .reason = "it is 2 plus powers of e^{4 i theta}, which as a function of "
                                   "the phase has double poles where |e^{2 i phase}| = 1/m",
                         .api = {"stokesbook::intrinsic_viscosity"}},
          .control = Control{"the mean over equal angles", orbit_errors(ratio, equal_angle)}};
}

const std::vector<double> ratios{1.0, 2.0, 5.0, 10.0};

double mean_error(double ratio, Angle angle) {
  const Index phases = ratio > 1.0 ? static_cast<Index>(std::ceil(44.0 / rate_of(ratio))) : 8;
  return std::abs(0.5 * mean_viscosity(resolved_ellipse(ratio), phases, angle) - 1.0);
}

/// Returns the largest relative error over angles against
/// (a + b)^2 / (2 a b) [sin^2 2 theta + 2 a b / (a^2 + b^2) cos^2 2 theta].
double instant_error(double ratio, StressletOf stresslet_of) {
  const FreeEllipse& ellipse = resolved_ellipse(ratio);
  double error = 0.0;
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.07 + 0.27 * k, c = std::cos(2.0 * angle), s = std::sin(2.0 * angle);
    const double exact = (ratio + 1.0) * (ratio + 1.0) / (2.0 * ratio) *
                         (s * s + 2.0 * ratio / (ratio * ratio + 1.0) * c * c);
    error = std::max(error,
                     std::abs(ellipse.intrinsic_viscosity_at(angle, stresslet_of) / exact - 1.0));
  }
  return error;
}

}  // namespace

Experiment stresslets() {
  return {.key = "stresslets",
          .title = "Stresslets of free ellipses in a shear flow",
          .x = "nodes N",
          .error = "error of S_11 + i S_12, relative",
          .axes = Axes::semi_log,
          .lines = {
              stresslet_line("two", "07_23", 2.0, "the normal into the fluid", with_inward_normal),
              stresslet_line("six", "07_24", 6.0, "the scalar product instead of the complex",
                             with_scalar_product)}};
}

Experiment orbits() {
  return {.key = "orbits",
          .title = "Intrinsic viscosity averaged over a Jeffery orbit",
          .x = "instants M",
          .error = "relative difference of the mean from 2",
          .axes = Axes::semi_log,
          .lines = {orbit_line("two", "07_25", 2.0), orbit_line("five", "07_26", 5.0),
                    orbit_line("ten", "07_27", 10.0)}};
}

Experiment aspect_ratios() {
  return {
      .key = "aspect",
      .title = "Intrinsic viscosity of ellipses: instants, and the mean over an orbit",
      .x = "aspect ratio λ",
      .error = "relative error",
      .axes = Axes::log_log,
      .lines = {
          {.key = "instant",
           .label = "at twelve angles",
           .measure =
               over(ratios, [](double ratio) { return instant_error(ratio, body_stresslet); }),
           .claim = Claim{.id = "07_28",
                          .statement =
                              "At every angle the intrinsic viscosity is that of the closed form.",
                          .law = Identity{1e-12},
                          .reason = "the nodes resolve the ellipse to rounding",
                          .api = {"stokesbook::intrinsic_viscosity"}},
           .control = Control{"the normal into the fluid", over(ratios,
                                                                [](double ratio) {
                                                                  return instant_error(
                                                                      ratio, with_inward_normal);
                                                                })}},
          {.key = "mean",
           .label = "mean over an orbit, from 2",
           .measure = over(ratios, [](double ratio) { return mean_error(ratio, orbit_angle); }),
           .claim = Claim{.id = "07_29",
                          .statement = "Over an orbit the mean is 2 for every aspect ratio.",
                          .law = Identity{1e-12},
                          .reason = "slender ellipses add most to the viscosity at the angles "
                                    "where they stay the shortest, and both factors cancel",
                          .api = {"stokesbook::intrinsic_viscosity"}},
           .control = Control{"the mean over equal angles", over(ratios, [](double ratio) {
                                return mean_error(ratio, equal_angle);
                              })}}}};
}

}  // namespace stokesbook::verification::stress
