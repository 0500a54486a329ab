#include "trapezoid/curve.hpp"

#include <numbers>

namespace stokesbook {

Curve place(const Curve& reference, Complex position, double orientation) {
  const Complex turn = std::polar(1.0, orientation);
  return {(position + (turn * reference.x).array()).matrix(), turn * reference.dx,
          turn * reference.ddx, reference.side};
}

ComplexVector all_nodes(const std::vector<Curve>& curves) {
  std::vector<Complex> nodes;
  for (const Curve& curve : curves) nodes.insert(nodes.end(), curve.x.begin(), curve.x.end());
  return Eigen::Map<const ComplexVector>(nodes.data(), static_cast<Eigen::Index>(nodes.size()));
}

Eigen::VectorXd weights(const Curve& curve) {
  return curve.dx.cwiseAbs() * (2.0 * std::numbers::pi / static_cast<double>(curve.size()));
}

ComplexVector normals(const Curve& curve) {
  return (-imaginary * curve.sign()) * curve.dx.cwiseQuotient(curve.dx.cwiseAbs());
}

Eigen::VectorXd curvatures(const Curve& curve) {
  const auto cross_product = (curve.dx.conjugate().array() * curve.ddx.array()).imag();
  return cross_product / curve.dx.array().abs().cube();
}

double perimeter(const Curve& curve) {
  return weights(curve).sum();
}

double area(const Curve& curve) {
  return (curve.x.conjugate().array() * curve.dx.array()).imag().sum() * std::numbers::pi /
         static_cast<double>(curve.size());
}

Complex boundary_centroid(const Curve& curve) {
  const Eigen::VectorXd w = weights(curve);
  return curve.x.cwiseProduct(w).sum() / w.sum();
}

double bounding_radius(const Curve& curve, Complex centre) {
  return (curve.x.array() - centre).abs().maxCoeff();
}

}  // namespace stokesbook
