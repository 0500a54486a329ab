// Solves for bodies in a container whose wall moves by a pure strain, which is the smallest
// suspension with an exact effective viscosity (07.18).
#include <algorithm>

#include "experiments.hpp"
#include "stress/dissipation.hpp"
#include "stress/stress.hpp"
#include "stress/stresslet.hpp"
#include "stress/traction.hpp"

namespace stokesbook::verification::stress {

using namespace study;
using Eigen::Index;

namespace {

const FlowDerivatives strained{0.0, 0.0, {1.0, -0.6}};

/// Returns the flow of free bodies in a circular container of radius 1 whose wall has the velocity
/// of the linear flow.
SolvedFlow in_container(std::vector<Component> bodies, double mu = viscosity) {
  Component wall = test::enclosing_wall(Circle{1.0}, 128, {});
  wall.velocity = linear_velocity(strained, wall.curve.x);
  bodies.push_back(wall);
  return test::solve_flow({bodies, mu, {}, {}});
}

const SolvedFlow& disk(double fraction) {
  static Once<double, SolvedFlow> solved;
  return solved(fraction, [&] {
    return in_container({test::free_body(Circle{std::sqrt(fraction)}, 128, {})});
  });
}

/// A planted defect: the fluid has viscosity 1.
SolvedFlow disk_in_other_fluid(double fraction) {
  return in_container({test::free_body(Circle{std::sqrt(fraction)}, 64, {})}, 1.0);
}

/// A planted defect: the disk is not in the middle.
SolvedFlow disk_off_the_middle(double fraction) {
  return in_container({test::free_body(Circle{std::sqrt(fraction)}, 64, {{0.2, 0.1}})});
}

/// A planted defect: the disk is in an unbounded fluid.
SolvedFlow disk_without_wall(double fraction) {
  const Component body = test::free_body(Circle{std::sqrt(fraction)}, 64, {});
  return test::solve_flow({{body}, viscosity, linear_velocity(strained, body.curve.x), {}});
}

/// Returns the dissipation relative to that of the fluid alone, mu |q|^2 pi.
double relative_power(const SolvedFlow& flow) {
  return total(power_of_loads(flow)) / (dissipation_density(strained, viscosity) * pi);
}

enum class Bodies {
  all,
  but_the_first  ///< a planted defect
};

/// Returns the sum of the stresslets of free bodies.
Complex stresslet_of_bodies(const SolvedFlow& flow, Bodies bodies) {
  Complex sum{};
  Index first = 0;
  for (const Component& component : flow.problem().components) {
    const Index n = component.curve.size();
    if (component.kind == ComponentKind::free_body && (bodies == Bodies::all || first > 0)) {
      sum += body_stresslet(component.curve, flow.density().segment(first, n), viscosity);
    }
    first += n;
  }
  return sum;
}

double excess_by_stresslets(const SolvedFlow& flow, Bodies bodies = Bodies::all) {
  return intrinsic_viscosity(stresslet_of_bodies(flow, bodies), strained.strain, pi, viscosity);
}

/// Returns the exact viscosity with a disk in the middle:
/// 1 + 2 phi (1 + phi + phi^2) / (1 - phi)^3.
double exact_viscosity(double phi) {
  return 1.0 + 2.0 * phi * (1.0 + phi + phi * phi) / std::pow(1.0 - phi, 3);
}

const std::vector<double> fractions{0.01, 0.05, 0.1, 0.2, 0.35, 0.5};

/// Returns two bodies without symmetry, scaled by a factor.
std::vector<Component> odd_bodies(double factor) {
  return {test::free_body(Ellipse{factor, 0.5 * factor}, 192, {{-0.4, 0.2}, 0.7}),
          test::free_body(test::lopsided_curve(0.5 * factor), 192, {{0.35, -0.2}, 0.3})};
}

const std::vector<double> factors{0.05, 0.1, 0.2, 0.3};

/// Measures the relative difference of the excess of the dissipation by tractions on the wall from
/// that by the stresslets.
Measure excess_differences(Bodies bodies) {
  return over(factors, [=](double factor) {
    static Once<double, SolvedFlow> solved;
    const SolvedFlow& flow = solved(factor, [&] { return in_container(odd_bodies(factor)); });
    const ComplexVector traction =
        boundary_traction(flow.problem(), flow.derivatives(flow.nodes()));
    const double power = total(boundary_power(flow, traction));
    const double excess = power / (dissipation_density(strained, viscosity) * pi) - 1.0;
    return std::abs(excess_by_stresslets(flow, bodies) / excess - 1.0);
  });
}

const std::vector<double> small_fractions{0.001, 0.002, 0.004, 0.008};

}  // namespace

Experiment container() {
  const auto by_power = [](const SolvedFlow& flow, double phi) {
    return std::abs(relative_power(flow) / exact_viscosity(phi) - 1.0);
  };
  const auto by_stresslet = [](const SolvedFlow& flow, double phi) {
    return std::abs((1.0 + excess_by_stresslets(flow)) / exact_viscosity(phi) - 1.0);
  };
  return {
      .key = "container",
      .title = "Effective viscosity of a disk in a container that is strained",
      .x = "area fraction φ",
      .error = "relative error",
      .axes = Axes::log_log,
      .lines = {
          {.key = "power",
           .label = "by the power of the wall",
           .measure = over(fractions, [=](double phi) { return by_power(disk(phi), phi); }),
           .claim = Claim{.id = "07_30",
                          .statement = "The effective viscosity by dissipation is "
                                       "1 + 2 p (1 + p + p^2) / (1 - p)^3.",
                          .law = Identity{1e-12},
                          .reason = "four Goursat terms solve the problem; the nodes resolve it",
                          .api = {"stokesbook::power_of_loads"}},
           .control = Control{"a fluid of viscosity 1", over(fractions,
                                                             [=](double phi) {
                                                               return by_power(
                                                                   disk_in_other_fluid(phi), phi);
                                                             })}},
          {.key = "stresslet",
           .label = "by the disk's stresslet",
           .measure = over(fractions, [=](double phi) { return by_stresslet(disk(phi), phi); }),
           .claim = Claim{.id = "07_31",
                          .statement = "The effective viscosity by the mean stress is the same.",
                          .law = Identity{1e-12},
                          .reason = "the wall's velocity is linear: the mean strain is that of "
                                    "the wall, and the mean stress is 2 mu E + S/A",
                          .api = {"stokesbook::body_stresslet", "stokesbook::intrinsic_viscosity"}},
           .control = Control{"a disk in an unbounded fluid", over(fractions, [=](double phi) {
                                return by_stresslet(disk_without_wall(phi), phi);
                              })}}}};
}

Experiment excess() {
  return {
      .key = "excess",
      .title = "Excess dissipation of two bodies in a strained container, and their stresslets",
      .x = "size of the bodies a",
      .error = "relative difference of excess and S:E",
      .axes = Axes::log_log,
      .lines = {
          {.key = "stresslets",
           .label = "stresslets against the wall's tractions",
           .measure = excess_differences(Bodies::all),
           .claim = Claim{.id = "07_32",
                          .statement = "The excess of the dissipation due to bodies is the sum of "
                                       "S:E, whatever their shapes and places.",
                          .law = Identity{1e-11},
                          .reason = "the reciprocal theorem between the flow with and "
                                    "without bodies",
                          .api = {"stokesbook::body_stresslet", "stokesbook::boundary_power"}},
           .control = Control{"one body's stresslet left out",
                              excess_differences(Bodies::but_the_first)}}}};
}

Experiment dilute() {
  const auto coefficient = [](double phi, double viscosity_of_disk) {
    return std::abs(viscosity_of_disk - 1.0 - 2.0 * phi) / (phi * phi);
  };
  return {
      .key = "dilute",
      .title = "The second coefficient of the effective viscosity",
      .x = "area fraction φ",
      .error = "(viscosity - 1 - 2φ) / φ², and its difference from 8",
      .axes = Axes::log_log,
      .lines = {
          {.key = "coefficient",
           .label = "second coefficient",
           .measure = over(small_fractions,
                           [=](double phi) { return coefficient(phi, relative_power(disk(phi))); }),
           .claim = Claim{.id = "07_33",
                          .statement = "After 1 + 2 p comes 8 p^2.",
                          .law = Floor{8.0, 1.03},
                          .reason = "1 + 2 p (1 + p + p^2)/(1 - p)^3 = 1 + 2 p + 8 p^2 + "
                                    "20 p^3 + ...",
                          .api = {"stokesbook::power_of_loads"}},
           .control = Control{"a disk in an unbounded fluid",
                              over(small_fractions,
                                   [=](double phi) {
                                     return coefficient(
                                         phi, 1.0 + excess_by_stresslets(disk_without_wall(phi)));
                                   })}},
          {.key = "rest",
           .label = "its difference from 8",
           .measure = over(small_fractions,
                           [=](double phi) {
                             return std::abs(coefficient(phi, relative_power(disk(phi))) - 8.0);
                           }),
           .claim = Claim{.id = "07_34",
                          .statement =
                              "The rest of the effective viscosity after 8 p^2 is of third order.",
                          .law = Algebraic{-1.0, 0.03},
                          .reason = "20 p^3",
                          .api = {"stokesbook::power_of_loads"}},
           .control = Control{"the disk not in the middle", over(small_fractions, [=](double phi) {
                                const double power = relative_power(disk_off_the_middle(phi));
                                return std::abs(coefficient(phi, power) - 8.0);
                              })}}}};
}

}  // namespace stokesbook::verification::stress
