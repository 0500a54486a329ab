#pragma once

#include <numbers>
#include <vector>

#include "double_layer/flow_derivatives.hpp"
#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::test {

/// Points with random normals and one weight, as a curve is to a sum over its nodes.
inline Curve cloud(const ComplexVector& points, double weight) {
  const double speed = weight * static_cast<double>(points.size()) / (2.0 * std::numbers::pi);
  const ComplexVector dx = speed * random_vector(points.size(), 99).cwiseSign();
  return {points, dx, dx, Side::fluid_outside};
}

/// Ellipses 2:1 in a square array, turned this way and that, n nodes each.
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

/// Nodes of all curves after each other.
inline ComplexVector all_nodes(const std::vector<Curve>& curves) {
  std::vector<Complex> nodes;
  for (const Curve& curve : curves) nodes.insert(nodes.end(), curve.x.begin(), curve.x.end());
  return Eigen::Map<const ComplexVector>(nodes.data(), static_cast<Eigen::Index>(nodes.size()));
}

/// Sets of n points that a tree may find hard, in a square of side 2 unless said.
struct PointSet {
  const char* name;
  ComplexVector points;
};
inline std::vector<PointSet> point_sets(Eigen::Index n) {
  const ComplexVector square = random_vector(n, 1), exponents = random_vector(n, 2);
  ComplexVector line(n), clusters(n), crowding(n), coincident(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    line[i] = {square[i].real(), 0.0};
    clusters[i] = square[i] + (i % 2 == 0 ? 0.0 : 1e4);
    crowding[i] = square[i] * std::exp(-9.0 * (1.0 + exponents[i].real()));
    coincident[i] = i % 4 == 0 ? square[i] : Complex{0.3, 0.4};
  }
  return {{"square", square},
          {"line", line},
          {"two clusters", clusters},
          {"crowding", crowding},
          {"coincident", coincident}};
}

/// Relative error in the 2-norm.
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
