// Assembles the double layer (02.6) of curves at their own nodes by the trapezoid rule, with the
// limit (02.9) of the kernel on the diagonal, and measures its error on rigid motions (02.7).
#include "double_layer/double_layer.hpp"

#include <algorithm>
#include <numbers>

#include "double_layer/stresslet_sum.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;

ComplexVector diagonal_velocity(const Curve& curve, const ComplexVector& density) {
  const double factor = -curve.sign() / static_cast<double>(curve.size());
  ComplexVector velocity(curve.size());
  for (Index j = 0; j < curve.size(); ++j) {
    // -(s kappa_j w_j / (2 pi)) t_j (t_j.eta_j) (02.9), by (01.2) and (01.4) equal to
    // -(s / N) (x' cross x'') / |x'|^2 x' (x'.eta) / |x'|^2.
    const Complex slope = curve.dx[j];
    const double square = std::norm(slope);
    velocity[j] =
        factor * (cross(slope, curve.ddx[j]) / square) * (dot(slope, density[j]) / square) * slope;
  }
  return velocity;
}

Eigen::MatrixXd double_layer_matrix(const Curve& curve) {
  return double_layer_matrix(std::vector<Curve>{curve});
}

Eigen::MatrixXd double_layer_matrix(const std::vector<Curve>& curves) {
  const ComplexVector targets = all_nodes(curves);
  Eigen::MatrixXd matrix(2 * targets.size(), 2 * targets.size());
  Index column = 0;
  for (const Curve& source : curves) {
    const Eigen::VectorXd w = weights(source), kappa = curvatures(source);
    const ComplexVector normal = normals(source);
    for (Index j = 0; j < source.size(); ++j, column += 2) {
      // (w / pi) (r.n) r r^T / rho^4, the kernel of (02.6) times the weight.
      const Complex x = source.x[j], n = w[j] * std::numbers::inv_pi * normal[j];
      double *first = matrix.col(column).data(), *second = matrix.col(column + 1).data();
#pragma omp simd
      for (Index i = 0; i < targets.size(); ++i) {
        const Complex r = targets[i] - x;
        const double inverse_square = 1.0 / std::norm(r);
        const Complex scaled = (inverse_square * dot(r, n)) * (inverse_square * r);
        first[2 * i] = scaled.real() * r.real();
        first[2 * i + 1] = second[2 * i] = scaled.real() * r.imag();
        second[2 * i + 1] = scaled.imag() * r.imag();
      }
      // The limit (02.9) on the diagonal, where r = 0: -(s kappa w / (2 pi)) t t^T.
      const Eigen::Vector2d slope(source.dx[j].real(), source.dx[j].imag());
      const double limit = -0.5 * std::numbers::inv_pi * source.sign() * kappa[j] * w[j];
      matrix.block<2, 2>(column, column) = limit / slope.squaredNorm() * slope * slope.transpose();
    }
  }
  return matrix;
}

double rigid_motion_residual(const Curve& curve) {
  const StressletSum sum({curve});
  const ComplexVector arm = (curve.x.array() - boundary_centroid(curve)).matrix();
  const double size = arm.cwiseAbs().maxCoeff();
  // D v = -s v / 2 for every rigid motion v (02.7); the residual's modes |k| <= 4 come first and
  // last among the coefficients.
  const auto residual = [&](const ComplexVector& v) {
    const ComplexVector error = sum(v) + diagonal_velocity(curve, v) + 0.5 * curve.sign() * v;
    const ComplexVector modes = fourier_coefficients(error);
    return std::max(modes.head(5).cwiseAbs().maxCoeff(), modes.tail(4).cwiseAbs().maxCoeff());
  };
  return std::max({residual(ComplexVector::Constant(curve.size(), 1.0)),
                   residual(ComplexVector::Constant(curve.size(), imaginary)),
                   residual(imaginary * arm) / size});
}

Eigen::MatrixXd interleaved_map(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  Eigen::MatrixXd map(2 * a.rows(), 2 * a.cols());
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = 0; i < a.rows(); ++i) {
      // The map takes 1 to a + b and i to i (a - b).
      const Complex sum = a(i, j) + b(i, j), difference = a(i, j) - b(i, j);
      map.block<2, 2>(2 * i, 2 * j) << sum.real(), -difference.imag(), sum.imag(),
          difference.real();
    }
  }
  return map;
}

}  // namespace stokesbook
