#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "double_layer/flow_derivatives.hpp"
#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::test {

/// Returns points with random normals and equal weights. The points have the type of a curve,
/// because the sums use only the nodes of a curve.
inline Curve cloud(const ComplexVector& points, double weight) {
  const double speed = weight * static_cast<double>(points.size()) / (2.0 * std::numbers::pi);
  const ComplexVector dx = speed * random_vector(points.size(), 99).cwiseSign();
  return {points, dx, dx, Side::fluid_outside};
}

/// Returns ellipses of aspect ratio 2:1 in a square array, at various angles, with n nodes each.
inline std::vector<Curve> ellipses(int side, Eigen::Index n) {
  const Curve ellipse = sample(Ellipse{1.0, 0.5}, n, Side::fluid_outside);
  const ComplexVector jitter = random_vector(side * side, 5);
  std::vector<Curve> curves;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const Complex random = jitter[i * side + j];
      curves.push_back(
          place(ellipse, 2.5 * Complex(i, j) + 0.2 * random, std::numbers::pi * random.real()));
    }
  }
  return curves;
}

/// @name Sets of n points, in a square of side 2 unless stated otherwise
/// @{
inline ComplexVector points_in_a_square(Eigen::Index n) {
  return random_vector(n, 1);
}
inline ComplexVector points_on_a_line(Eigen::Index n) {
  return random_vector(n, 1).real().cast<Complex>();
}
/// Returns points in two squares whose distance is ten thousand.
inline ComplexVector two_clusters(Eigen::Index n) {
  ComplexVector points = random_vector(n, 1);
  for (Eigen::Index i = 1; i < n; i += 2) points[i] += 1e4;
  return points;
}
/// Returns points that accumulate at the origin, over eight decades.
inline ComplexVector crowding_points(Eigen::Index n) {
  const Eigen::ArrayXd exponents = -9.0 * (1.0 + random_vector(n, 2).real().array());
  return (random_vector(n, 1).array() * exponents.exp()).matrix();
}
/// Returns points of which three quarters coincide.
inline ComplexVector coincident_points(Eigen::Index n) {
  ComplexVector points = random_vector(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i % 4 != 0) points[i] = {0.3, 0.4};
  }
  return points;
}
/// @}

/// Holds a set of n points that may be difficult for a tree.
struct PointSet {
  const char* name;
  ComplexVector points;
};
inline std::vector<PointSet> point_sets(Eigen::Index n) {
  return {{"square", points_in_a_square(n)},
          {"line", points_on_a_line(n)},
          {"two clusters", two_clusters(n)},
          {"crowding", crowding_points(n)},
          {"coincident", coincident_points(n)}};
}

/// Returns the relative error in the 2-norm.
inline double relative_error(const ComplexVector& found, const ComplexVector& exact) {
  return (found - exact).norm() / exact.norm();
}

inline double relative_error(const std::vector<FlowDerivatives>& found,
                             const std::vector<FlowDerivatives>& exact) {
  double error2 = 0.0, norm2 = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const FlowDerivatives &f = found[i], &e = exact[i];
    error2 += std::norm(Complex{f.pressure - e.pressure, f.vorticity - e.vorticity}) +
              std::norm(f.strain - e.strain);
    norm2 += std::norm(Complex{e.pressure, e.vorticity}) + std::norm(e.strain);
  }
  return std::sqrt(error2 / norm2);
}

}  // namespace stokesbook::test
