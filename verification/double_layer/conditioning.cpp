// Computes condition numbers of the equation of the second kind, which do not depend on the number
// of nodes, and of an equation of the first kind, which do.
#include <cmath>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/dirichlet.hpp"
#include "support/spectra.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

/// Returns the condition number of a matrix of node values, in the mean-square norm of functions on
/// the curve.
double condition(const Curve& curve, const Eigen::MatrixXd& matrix) {
  Eigen::VectorXd scale(2 * curve.size());
  const Eigen::VectorXd w = weights(curve).cwiseSqrt();
  for (Index i = 0; i < scale.size(); ++i) scale[i] = w[i / 2];
  return test::condition_number(scale.asDiagonal() * matrix * scale.cwiseInverse().asDiagonal());
}

double second_kind(const Curve& curve) {
  return condition(curve, test::completed_system(curve, double_layer_matrix(curve)));
}

/// A planted defect: -1/2 + D has no completion, and is singular on rigid motions.
double not_completed(const Curve& curve) {
  const Index n = 2 * curve.size();
  return condition(curve, double_layer_matrix(curve) - 0.5 * Eigen::MatrixXd::Identity(n, n));
}

/// A planted defect: the normal points into the fluid, and the completion is that of the right
/// normal.
double inward_normal(const Curve& curve) {
  return condition(curve, test::completed_system(curve, -double_layer_matrix(curve)));
}

/// Returns Kress' weights of the trapezoid rule for the factor log(4 sin^2((t_0 - t_k) / 2)).
Eigen::VectorXd logarithmic_weights(Index n) {
  const auto nodes = static_cast<double>(n);
  return Eigen::VectorXd::NullaryExpr(n, [=](Index k) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(k) / nodes;
    double sum = std::cos(0.5 * nodes * t) / nodes;
    for (Index m = 1; m < n / 2; ++m) {
      sum += std::cos(static_cast<double>(m) * t) / static_cast<double>(m);
    }
    return -4.0 * std::numbers::pi / nodes * sum;
  });
}

/// Returns the condition number of an equation of the first kind for the same problem. The equation
/// contains the single layer of Stokeslets, completed on its null vector n.
double first_kind(const Curve& curve) {
  constexpr double gauge = 20.0, viscosity = 1.0;
  const Index n = curve.size();
  const double h = 2.0 * std::numbers::pi / static_cast<double>(n);
  const Eigen::VectorXd singular = logarithmic_weights(n);
  const Eigen::VectorXd w = weights(curve);
  Eigen::MatrixXd layer(2 * n, 2 * n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      for (const Index column : {0, 1}) {
        const Complex force = column == 0 ? 1.0 : imaginary;
        const Complex tangent = curve.dx[j] / std::abs(curve.dx[j]);
        const double sine = 2.0 * std::sin(0.5 * h * static_cast<double>(i - j));
        const Complex smooth =
            i == j ? (-std::log(std::abs(curve.dx[j]) / gauge) * force +
                      tangent * dot(tangent, force)) /
                         (4.0 * std::numbers::pi * viscosity)
                   : stokeslet(curve.x[i] - curve.x[j], force, viscosity, gauge) +
                         std::log(std::abs(sine)) * force / (4.0 * std::numbers::pi * viscosity);
        const Complex entry = w[j] * (smooth - 0.5 * singular[std::abs(i - j)] / h * force /
                                                   (4.0 * std::numbers::pi * viscosity));
        layer(2 * i, 2 * j + column) = entry.real();
        layer(2 * i + 1, 2 * j + column) = entry.imag();
      }
    }
  }
  const ComplexVector normal = normals(curve), weighted = normal.cwiseProduct(w);
  layer += interleaved(normal) * interleaved(weighted).transpose();
  return condition(curve, layer);
}

Measure over_nodes(const Shape& shape, double (*number)(const Curve&)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index n = 16; n <= (size == Size::full ? 256 : 80); n = n * 3 / 2 / 2 * 2) {
      const Curve curve = sample(shape, n, Side::fluid_outside);
      measurements.push_back({.x = static_cast<double>(n),
                              .error = number(curve),
                              .unknowns = 2.0 * static_cast<double>(n)});
    }
    return measurements;
  };
}

}  // namespace

Experiment conditioning() {
  const Shape circle = Circle{0.7}, ellipse = Ellipse{2.0, 1.0};
  return {
      .key = "conditioning",
      .title = "Condition of equations of the second and of the first kind, one body",
      .x = "nodes N",
      .error = "condition number, in the norm of functions on the curve",
      .lines = {
          {.key = "circle",
           .label = "-1/2 + D completed, circle",
           .measure = over_nodes(circle, second_kind),
           .claim = Claim{.id = "02_25",
                          .statement = "On a circle the completed equation has the condition "
                                       "number 2 at any number of nodes.",
                          .law = Floor{2.0, 1.0 + 1e-12},
                          .reason = "eigenvalues -1 on rigid motions and on the normal, -1/2 on "
                                    "all else",
                          .api = {"stokesbook::double_layer_matrix"}},
           .control = Control{"-1/2 + D not completed: singular on rigid motions",
                              over_nodes(circle, not_completed)}},
          {.key = "ellipse",
           .label = "-1/2 + D completed, ellipse 2:1",
           .measure = over_nodes(ellipse, second_kind),
           .claim = Claim{.id = "02_26",
                          .statement = "On an ellipse its condition number does not depend on the "
                                       "number of nodes either.",
                          .law = Algebraic{0.0, 0.02},
                          .reason = "second kind: D is compact, so that new nodes bring "
                                    "eigenvalues near -1/2 only",
                          .api = {"stokesbook::double_layer_matrix"}},
           .control = Control{"an equation of the first kind: the single layer",
                              over_nodes(ellipse, first_kind)}},
          {.key = "first",
           .label = "single layer, first kind, ellipse 2:1",
           .measure = over_nodes(ellipse, first_kind)},
          {.key = "inward",
           .label = "the normal into the fluid, ellipse 2:1",
           .measure = over_nodes(ellipse, inward_normal)}}};
}

}  // namespace stokesbook::verification::double_layer
