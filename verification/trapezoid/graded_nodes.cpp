// Integrates functions with near poles on graded nodes; the rates are predicted from the map of the
// parameter (06.18).
#include <cmath>
#include <functional>

#include "experiments.hpp"
#include "support/over_nodes.hpp"
#include "trapezoid/grading.hpp"

namespace stokesbook::verification::trapezoid {

using namespace study;
using Eigen::Index;

namespace {

Grading about_the_poles(double width) {
  return {{{0.0, width}}};
}

/// Integrates by the rule in s: the weights are 2 pi / n times dt/ds.
double graded_rule(const PoleFunction& f, const Grading& grading, Index n) {
  double sum = 0.0;
  for (const GradedParameter& node : graded_parameters(grading, n)) sum += f(node.t) * node.dt;
  return 2.0 * std::numbers::pi / static_cast<double>(n) * sum;
}

/// A planted defect: the weight is the step to the next node instead of dt/ds 2 pi / n.
double rule_of_steps(const PoleFunction& f, const Grading& grading, Index n) {
  constexpr double period = 2.0 * std::numbers::pi;
  const std::vector<GradedParameter> nodes = graded_parameters(grading, n);
  double sum = 0.0;
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const double step = nodes[(j + 1) % nodes.size()].t - nodes[j].t;
    sum += f(nodes[j].t) * (step - period * std::floor(step / period));
  }
  return sum;
}

using Rule = std::function<double(const PoleFunction&, const Grading&, Index)>;

Measure graded_errors(const PoleFunction& f, const Grading& grading, const Rule& rule) {
  const double rate = graded_depth(grading, 0.0, f.distance());
  const auto error = [=](Index n) { return std::abs(rule(f, grading, n) / f.integral() - 1.0); };
  return test::over_nodes(0.0, 36.0 / rate, 24, error, 1.0);
}

/// @param  ratio  width of the cluster of nodes relative to the distance of the poles
Line pole_line(const std::string& key, const std::string& label, const std::string& id,
               double distance, double ratio) {
  const PoleFunction f(distance);
  const Grading grading = about_the_poles(ratio * distance);
  const double rate = graded_depth(grading, 0.0, distance);
  return {
      .key = key,
      .label = label,
      .measure = graded_errors(f, grading, graded_rule),
      .claim = Claim{.id = id,
                     .statement = "On nodes that crowd about poles at a distance d the integral "
                                  "converges as e^{-r N}, r the depth of the poles in the new "
                                  "parameter.",
                     .law = Geometric{rate, 0.02},
                     .window = {.from = 2.0 / rate, .floor = 1e-15},
                     .reason = "the map is analytic about the real axis as far as the poles",
                     .api = {"stokesbook::graded_depth", "stokesbook::graded_parameters"}},
      .control = Control{"steps between neighbours as weights, for dt/ds",
                         graded_errors(f, grading, rule_of_steps)}};
}

/// Returns the least even number of nodes for which a rule has an error below a tolerance, by
/// bisection.
template <class Error>
double nodes_needed(double tolerance, const Error& error) {
  Index enough = 4;
  while (error(enough) > tolerance) enough *= 2;
  Index too_few = enough / 2;
  while (enough - too_few > 2) {
    const Index middle = 2 * ((enough + too_few) / 4);
    (error(middle) > tolerance ? too_few : enough) = middle;
  }
  return static_cast<double>(enough);
}

Measure counts(const std::function<double(const PoleFunction&, Index)>& rule) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double least = size == Size::full ? 1e-5 : 1e-4;
    for (double d = 1.0; d > 0.9 * least; d *= std::sqrt(0.1)) {
      const PoleFunction f(d);
      const auto error = [&](Index n) { return std::abs(rule(f, n) / f.integral() - 1.0); };
      measurements.push_back({.x = 1.0 / d, .error = nodes_needed(1e-10, error)});
    }
    return measurements;
  };
}

}  // namespace

Experiment graded_poles() {
  return {.key = "graded",
          .title = "Nodes that crowd about poles",
          .x = "nodes N",
          .error = "relative error of the integral",
          .axes = Axes::semi_log,
          .lines = {pole_line("tenth", "distance 0.1", "01_15", 0.1, 1.0),
                    pole_line("thousandth", "distance 10^-3", "01_16", 1e-3, 1.0),
                    pole_line("millionth", "distance 10^-6", "01_17", 1e-6, 1.0),
                    pole_line("wide", "distance 10^-3, cluster 10^-2", "01_18", 1e-3, 10.0)}};
}

Experiment graded_counts() {
  const auto equidistant = [](const PoleFunction& f, Index n) { return trapezoid_rule(n, f); };
  const auto graded = [](const PoleFunction& f, Index n) {
    return graded_rule(f, about_the_poles(f.distance()), n);
  };
  return {.key = "graded_counts",
          .title = "Nodes for a relative error of 1e-10",
          .x = "inverse distance of the poles (1/d)",
          .error = "number of nodes",
          .lines = {{.key = "equidistant",
                     .label = "equidistant",
                     .measure = counts(equidistant),
                     .claim = Claim{.id = "01_19",
                                    .statement = "Equidistant nodes are needed in numbers that "
                                                 "grow as the inverse distance of the poles.",
                                    .law = Algebraic{-1.0, 0.03},
                                    .window = {.from = 9.0},
                                    .reason = "N = ln(2e10) / d",
                                    .api = {"stokesbook::weights"}},
                     .control = Control{"nodes that crowd about the poles", counts(graded)}},
                    {.key = "graded", .label = "crowding", .measure = counts(graded)}}};
}

}  // namespace stokesbook::verification::trapezoid
