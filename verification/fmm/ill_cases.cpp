// Measures errors for node sets that may be difficult for a tree.
#include <cmath>

#include "experiments.hpp"
#include "set_ups.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::fmm {

using namespace study;
using Eigen::Index;

namespace {

using MakeSum = Summed (*)();
using Choice = FmmSettings (*)(double tolerance);

Summed line_of_points() {
  return Summed(as_nodes(test::points_on_a_line(4000)));
}
Summed distant_clusters() {
  return Summed(as_nodes(test::two_clusters(4000)));
}
Summed slender_body() {
  return summed_slender_body();
}
Summed coincident() {
  return Summed(as_nodes(test::coincident_points(4000)));
}

std::vector<Curve> scaled(std::vector<Curve> curves, double length) {
  for (Curve& curve : curves) {
    curve.x *= length;
    curve.dx *= length;
    curve.ddx *= length;
  }
  return curves;
}
Summed micrometres() {
  return Summed(scaled(ellipses(4000), 1e-6));
}
Summed kilometres() {
  return Summed(scaled(ellipses(4000), 1e6));
}

/// Returns settings with an order that suffices for any nodes: p 2^-p <= tolerance.
FmmSettings guaranteed(double tolerance) {
  FmmSettings settings = FmmSettings::for_tolerance(tolerance);
  while (settings.order * std::exp2(-settings.order) > tolerance) ++settings.order;
  return settings;
}

/// A planted defect: the order is half of the chosen order.
template <Choice choice>
FmmSettings half_of(double tolerance) {
  FmmSettings settings = choice(tolerance);
  settings.order /= 2;
  return settings;
}

Measure over_tolerances(MakeSum make, Choice choice) {
  return [=](Size) {
    const Summed sum = make();
    std::vector<Measurement> measurements;
    for (const double tolerance : {1e-12, 1e-9, 1e-6, 1e-3}) {
      measurements.push_back({.x = tolerance, .error = velocity_error(sum, choice(tolerance))});
    }
    return measurements;
  };
}

template <Choice choice>
Line line(const std::string& key, const std::string& id, const std::string& label, MakeSum make) {
  return {.key = key,
          .label = label,
          .measure = over_tolerances(make, choice),
          .claim = Claim{.id = id,
                         .statement = "The tolerance is met: " + label + ".",
                         .law = ErrorBelowTolerance{1.0, 1e-4},
                         .reason = "boxes are tight, and no number in the sum has a length",
                         .api = {"stokesbook::Fmm", "stokesbook::Quadtree"}},
          .control = Control{"half of the order", over_tolerances(make, half_of<choice>)}};
}

}  // namespace

Experiment ill_cases() {
  return {
      .key = "ill",
      .title = "What a tree may find hard",
      .x = "tolerance ε",
      .error = "error of the velocity in the 2-norm, relative",
      .lines = {
          line<FmmSettings::for_tolerance>("line", "08_21", "all nodes on a line", line_of_points),
          line<FmmSettings::for_tolerance>(
              "clusters", "08_22", "two clusters ten thousand sizes apart", distant_clusters),
          line<FmmSettings::for_tolerance>("body", "08_23", "one slender body", slender_body),
          line<FmmSettings::for_tolerance>("small", "08_24", "lengths of 1e-6", micrometres),
          line<FmmSettings::for_tolerance>("large", "08_25", "lengths of 1e6", kilometres),
          line<guaranteed>("coincident", "08_26",
                           "three quarters of the nodes at one place, guaranteed order",
                           coincident),
          {.key = "unguarded",
           .label = "three quarters at one place, usual order",
           .measure = over_tolerances(coincident, FmmSettings::for_tolerance)}}};
}

}  // namespace stokesbook::verification::fmm
