#include "stiv/contact_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace stokesbook {

using Eigen::Index;

namespace {

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

// As many nodes as see every bend of a shape.
Index resolving_nodes(const Shape& shape) {
  const auto* nodal = std::get_if<NodalCurve>(&shape);
  return std::max<Index>(256, nodal ? 2 * nodal->points.size() : 0);
}

}  // namespace

double sag(const Curve& curve) {
  const double step = 2.0 * std::numbers::pi / static_cast<double>(curve.size());
  const auto bend = (curve.dx.conjugate().array() * curve.ddx.array()).imag().abs();
  return (bend / curve.dx.array().abs()).maxCoeff() * step * step / 8.0;
}

ContactShape contact_shape(const Curve& curve) {
  return {Polygon(curve.x, curve.side), half_edges(curve.x), sag(curve),
          bounding_radius(curve, 0.0)};
}

ContactShape contact_shape(const Shape& shape, Side side, double sag_limit) {
  if (!(sag_limit > 0.0)) {
    throw std::invalid_argument("a contact shape's sag must be positive, got " +
                                std::to_string(sag_limit));
  }
  const auto nodes_for = [&](const Curve& curve) {
    const double ratio = std::sqrt(sag(curve) / sag_limit);
    const double half = std::ceil(0.5 * ratio * static_cast<double>(curve.size()));
    return std::max<Index>(16, 2 * static_cast<Index>(half));
  };
  const Curve fine = sample(shape, resolving_nodes(shape), side);
  Curve curve = sample(shape, nodes_for(fine), side);
  while (sag(curve) > sag_limit) {
    curve = sample(shape, std::max(nodes_for(curve), curve.size() + 2), side);
  }
  return contact_shape(curve);
}

}  // namespace stokesbook
