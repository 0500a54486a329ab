// Computes perimeters of ellipses: the speed |x'| has branch points, which are near the real axis
// if the ellipse is slender (01.8).
#include <cmath>

#include <gsl/gsl_sf_ellint.h>

#include "experiments.hpp"
#include "support/over_nodes.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::verification::trapezoid {

using namespace study;
using Eigen::Index;

namespace {

double exact_perimeter(const Ellipse& e) {
  // The elliptic integral is GSL's, because that of libstdc++ has errors of 1e-13.
  return 4.0 * e.a * gsl_sf_ellint_Ecomp(std::sqrt(1.0 - e.b * e.b / (e.a * e.a)), GSL_PREC_DOUBLE);
}

/// A planted defect: the perimeter is that of the polygon through the nodes.
double polygon_perimeter(const Curve& curve) {
  double length = 0.0;
  for (Index j = 0; j < curve.size(); ++j) {
    length += std::abs(curve.x[(j + 1) % curve.size()] - curve.x[j]);
  }
  return length;
}

template <class Perimeter>
Measure relative_errors(const Ellipse& ellipse, double distance, const Perimeter& length) {
  const auto error = [=](Index n) {
    const Curve curve = sample(ellipse, n, Side::fluid_outside);
    return std::abs(length(curve) / exact_perimeter(ellipse) - 1.0);
  };
  return test::over_nodes(0.0, 30.0 / distance, 20, error, 1.0);
}

Line perimeter_line(const std::string& key, const std::string& id, double aspect) {
  const Ellipse ellipse{aspect, 1.0};
  const double distance = std::atanh(1.0 / aspect);
  return {.key = key,
          .label = "ellipse " + std::to_string(static_cast<int>(aspect)) + ":1",
          .measure = relative_errors(ellipse, distance, perimeter),
          .claim = Claim{.id = id,
                         .statement = "The perimeter of an ellipse converges as N^(-3/2) e^{-d N} "
                                      "with tanh d = b / a: slender ellipses need N in proportion "
                                      "to their aspect ratio.",
                         .law = Geometric{distance, 0.03, -1.5},
                         .window = {.from = 4.0 / distance, .floor = 1e-15},
                         .reason = "|x'|^2 = a^2 sin^2 t + b^2 cos^2 t vanishes at t = +-i d: "
                                   "square roots there",
                         .api = {"stokesbook::perimeter", "stokesbook::sample"}},
          .control = Control{"the polygon through the nodes",
                             relative_errors(ellipse, distance, polygon_perimeter)}};
}

}  // namespace

Experiment perimeters() {
  return {.key = "perimeters",
          .title = "Perimeters of slender ellipses",
          .x = "nodes N",
          .error = "relative error of the perimeter",
          .axes = Axes::semi_log,
          .lines = {perimeter_line("two", "01_9", 2.0), perimeter_line("five", "01_10", 5.0),
                    perimeter_line("twenty", "01_11", 20.0)}};
}

}  // namespace stokesbook::verification::trapezoid
