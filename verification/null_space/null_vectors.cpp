// The two null vectors of -1/2 + D on an elliptic wall: n on the left, n |x'| on the right.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr Ellipse ellipse{3.0, 1.0};

Curve wall(Index n) {
  return place(sample(ellipse, n, Side::fluid_inside), {0.4, -0.3}, 0.7);
}

MatrixXd layer_with_jump(const Curve& curve) {
  MatrixXd matrix = double_layer_matrix(curve);
  matrix.diagonal().array() -= 0.5;
  return matrix;
}

/// The velocity at which an ellipse grows when a pressure inside blows it up; it stays an ellipse.
ComplexVector blown_up(const Curve& curve) {
  return normals(curve).cwiseProduct(curve.dx.cwiseAbs());
}

/// |v^T W (-1/2 + D)| in the mean square, relative to v; W holds the weights.
double left_residual(const Curve& curve, const ComplexVector& v) {
  const Eigen::VectorXd w = weights(curve);
  const ComplexVector weighted = v.cwiseProduct(w);
  const Eigen::VectorXd image = layer_with_jump(curve).transpose() * interleaved(weighted);
  return test::largest(deinterleaved(image).cwiseQuotient(w)) / test::largest(v);
}

/// |(-1/2 + D) v| relative to v.
double right_residual(const Curve& curve, const ComplexVector& v) {
  const Eigen::VectorXd image = layer_with_jump(curve) * interleaved(v);
  return test::largest(deinterleaved(image)) / test::largest(v);
}

using Residual = double (*)(const Curve&, const ComplexVector&);
using NodeVector = ComplexVector (*)(const Curve&);

Measure residuals(Residual residual, NodeVector vector) {
  std::vector<Index> counts;
  for (Index n = 8; n <= 60; n += 4) counts.push_back(n);
  return over_nodes(counts, [=](Index n) { return residual(wall(n), vector(wall(n))); });
}

}  // namespace

Experiment null_vectors() {
  const double rate = std::log((ellipse.a + ellipse.b) / (ellipse.a - ellipse.b));
  return {
      .key = "vectors",
      .title = "Null vectors of -1/2 + D on an elliptic wall 3:1",
      .x = "nodes N",
      .error = "largest residual, relative to the vector",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "left",
           .label = "n from the left",
           .measure = residuals(left_residual, normals),
           .claim = Claim{.id = "04_4",
                          .statement = "The normal is the left null vector of -1/2 + D, up to the "
                                       "rule's error N m^N, m = (a - b) / (a + b).",
                          .law = Geometric{rate, 0.02, 1.0},
                          .window = {.from = 16.0, .floor = 1e-15},
                          .reason = "double layers carry no flux; the kernel's modes k m^(k-1) "
                                    "alias by N",
                          .api = {"stokesbook::null_space_velocity", "stokesbook::normals"}},
           .control = Control{"n |x'| from the left", residuals(left_residual, blown_up)}},
          {.key = "right",
           .label = "n |x'| from the right",
           .measure = residuals(right_residual, blown_up),
           .claim = Claim{.id = "04_5",
                          .statement = "The right null vector of an ellipse is n |x'|: as the "
                                       "ellipse would grow if a pressure inside blew it up.",
                          .law = Geometric{rate, 0.02, 1.0},
                          .window = {.from = 16.0, .floor = 1e-15},
                          .reason = "the spectrum of the ellipse: modes +-1 of eigenvalue 1/2",
                          .api = {"stokesbook::double_layer_matrix"}},
           .control = Control{"n from the right", residuals(right_residual, normals)}},
          {.key = "normal",
           .label = "n from the right",
           .measure = residuals(right_residual, normals)}}};
}

}  // namespace stokesbook::verification::null_space
