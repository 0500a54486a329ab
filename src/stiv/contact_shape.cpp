// Makes the polygon by which contact sees a curve, with as many vertices as a limit of the sag
// (10.1) requires.
#include "stiv/contact_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Returns for each vertex half the lengths of its two edges: the weights w_s of (10.6).
Eigen::VectorXd half_edges(const ComplexVector& vertices) {
  const Index m = vertices.size();
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(m);
  for (Index i = 0; i < m; ++i) {
    const Index next = (i + 1) % m;
    const double half = 0.5 * std::abs(vertices[next] - vertices[i]);
    weights[i] += half;
    weights[next] += half;
  }
  return weights;
}

// Returns a number of nodes that resolves the curvature of a shape.
Index resolving_nodes(const Shape& shape) {
  const auto* nodal = std::get_if<NodalCurve>(&shape);
  return std::max<Index>(256, nodal ? 2 * nodal->points.size() : 0);
}

// Returns max |x' cross x''| / |x'|, the largest component of x'' normal to the curve. The sag
// (10.1) is this number times h^2/8, with the spacing h of the nodes in the curve's parameter.
double bend(const Curve& curve) {
  const auto across = (curve.dx.conjugate().array() * curve.ddx.array()).imag().abs();
  return (across / curve.dx.array().abs()).maxCoeff();
}

// Returns the sag (10.1) for n nodes.
double sag(double bend, Index n) {
  const double step = 2.0 * std::numbers::pi / static_cast<double>(n);
  return bend * step * step / 8.0;
}

// Returns the least even number of nodes, at least 16, whose sag (10.1) is at most sag_limit.
Index nodes_for(double bend, double sag_limit) {
  const double half = std::ceil(std::numbers::pi * std::sqrt(bend / (8.0 * sag_limit)));
  return std::max<Index>(16, 2 * static_cast<Index>(half));
}

ContactShape with_sag(const Curve& curve, double sag) {
  return {Polygon(curve.x, curve.side), half_edges(curve.x), sag, bounding_radius(curve, 0.0)};
}

}  // namespace

double sag(const Curve& curve) {
  return sag(bend(curve), curve.size());
}

ContactShape contact_shape(const Curve& curve) {
  return with_sag(curve, sag(curve));
}

ContactShape contact_shape(const Shape& shape, Side side, double sag_limit) {
  require(sag_limit > 0.0, "a contact shape's sag must be positive, got ", sag_limit);
  const double fine_bend = bend(sample(shape, resolving_nodes(shape), side));
  const Index n = nodes_for(fine_bend, sag_limit);
  return with_sag(sample(shape, n, side), sag(fine_bend, n));
}

}  // namespace stokesbook
