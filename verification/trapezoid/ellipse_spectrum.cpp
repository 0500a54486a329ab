// Compares the spectrum of the double layer of an ellipse, by collocation at the nodes, with its
// closed form (01.10).
#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/spectra.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::verification::trapezoid {

using namespace study;
using Eigen::Index;

namespace {

constexpr Index outer = 9;  // number of eigenvalues compared at either end of the spectrum

/// A planted defect: the diagonal of the kernel has the opposite sign of the curvature.
Eigen::MatrixXd with_wrong_diagonal(const Curve& curve) {
  Eigen::MatrixXd matrix = double_layer_matrix(curve);
  for (Index j = 0; j < curve.size(); ++j) matrix.block<2, 2>(2 * j, 2 * j) *= -1.0;
  return matrix;
}

template <class Assemble>
Measure errors(double aspect, const Assemble& assemble) {
  const double m = (aspect - 1.0) / (aspect + 1.0);
  return [=](Size size) {
    const double step = (size == Size::full ? 1.0 : 3.0) / -std::log(m);
    std::vector<Measurement> measurements;
    Index last = 0;
    for (double target = 12.0 / -std::log(m); target <= 42.0 / -std::log(m); target += step) {
      const Index n = 2 * std::lround(0.5 * target);
      if (n == last) continue;
      last = n;
      const Ellipse ellipse{aspect, 1.0};
      const Eigen::MatrixXd layer = assemble(sample(ellipse, n, Side::fluid_outside));
      measurements.push_back({.x = static_cast<double>(n),
                              .error = test::spectrum_distance(
                                  test::eigenvalues(layer),
                                  test::ellipse_spectrum(ellipse, Side::fluid_outside, n), outer),
                              .unknowns = 2.0 * static_cast<double>(n)});
    }
    return measurements;
  };
}

Line spectrum_line(const std::string& key, const std::string& id, double aspect) {
  const double m = (aspect - 1.0) / (aspect + 1.0);
  const auto assemble = [](const Curve& curve) { return double_layer_matrix(curve); };
  return {.key = key,
          .label = "ellipse " + std::to_string(static_cast<int>(aspect)) + ":1",
          .measure = errors(aspect, assemble),
          .claim = Claim{.id = id,
                         .statement = "Collocation gives the eigenvalues of the double layer of "
                                      "an ellipse with an error N m^N, m = (a - b) / (a + b).",
                         .law = Geometric{-std::log(m), 0.02, 1.0},
                         .window = {.from = 20.0 / -std::log(m), .floor = 1e-15},
                         .reason = "the kernel's modes k m^(k-1) alias by N",
                         .api = {"stokesbook::double_layer_matrix"}},
          .control = Control{"the diagonal with the other sign of the curvature",
                             errors(aspect, with_wrong_diagonal)}};
}

}  // namespace

Experiment ellipse_spectrum() {
  return {.key = "spectrum",
          .title = "Spectrum of the double layer of an ellipse",
          .x = "nodes N",
          .error = "largest error of the nine least and the nine largest eigenvalues",
          .axes = Axes::semi_log,
          .lines = {spectrum_line("two", "01_12", 2.0), spectrum_line("three", "01_13", 3.0)}};
}

}  // namespace stokesbook::verification::trapezoid
