#include "double_layer/double_layer.hpp"

#include <algorithm>
#include <numbers>

#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;

ComplexVector diagonal_velocity(const Curve& curve, const ComplexVector& density) {
  const Eigen::VectorXd w = weights(curve);
  const Eigen::VectorXd kappa = curvatures(curve);
  ComplexVector velocity(curve.size());
  for (Index j = 0; j < curve.size(); ++j) {
    const Complex tangent = curve.dx[j] / std::abs(curve.dx[j]);
    const double factor = -curve.sign() * kappa[j] * w[j] / (2.0 * std::numbers::pi);
    velocity[j] = factor * dot(tangent, density[j]) * tangent;
  }
  return velocity;
}

Eigen::MatrixXd double_layer_matrix(const Curve& curve) {
  const Index n = curve.size();
  const Eigen::VectorXd w = weights(curve);
  const Eigen::VectorXd kappa = curvatures(curve);
  const ComplexVector normal = normals(curve);
  Eigen::MatrixXd matrix(2 * n, 2 * n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      // Off the diagonal (w/pi) (r.n) r r^T / rho^4, on it its limit along the tangent.
      Complex direction = curve.dx[j];
      double factor = -0.5 * curve.sign() * kappa[j] * w[j] * std::numbers::inv_pi;
      if (i != j) {
        direction = curve.x[i] - curve.x[j];
        factor = w[j] * std::numbers::inv_pi * dot(direction, normal[j]) / std::norm(direction);
      }
      factor /= std::norm(direction);
      const Eigen::Vector2d r{direction.real(), direction.imag()};
      matrix.block<2, 2>(2 * i, 2 * j) = factor * r * r.transpose();
    }
  }
  return matrix;
}

double rigid_motion_residual(const Curve& curve) {
  const Eigen::MatrixXd matrix = double_layer_matrix(curve);
  const ComplexVector arm = (curve.x.array() - boundary_centroid(curve)).matrix();
  const double size = arm.cwiseAbs().maxCoeff();
  // D v = -s v / 2 for every rigid motion v.
  const auto residual = [&](const ComplexVector& v) {
    const Eigen::VectorXd error = matrix * interleaved(v) + 0.5 * curve.sign() * interleaved(v);
    const ComplexVector modes = fourier_coefficients(deinterleaved(error));
    return std::max(modes.head(5).cwiseAbs().maxCoeff(), modes.tail(4).cwiseAbs().maxCoeff());
  };
  return std::max({residual(ComplexVector::Constant(curve.size(), 1.0)),
                   residual(ComplexVector::Constant(curve.size(), imaginary)),
                   residual(imaginary * arm) / size});
}

}  // namespace stokesbook
