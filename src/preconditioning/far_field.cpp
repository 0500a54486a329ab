// Assembles the operators of the fast multipole method (08.6) to (08.13) as matrices, column by
// column from unit coefficients, for the far couplings of a HierarchicalPreconditioner (chapter
// 13).
#include "preconditioning/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "double_layer/stresslet_block.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXf;

namespace {

Eigen::VectorXf as_vector(const Expansion& expansion) {
  return expansion.reshaped().matrix().cast<float>();
}

// Assembles a linear map of expansions from the images of the unit expansions. It leaves the flux
// through a wall, the last coefficient, as it is.
template <class Map>
MatrixXf assembled(const Expansions& units, int order, Index size, const Map& map) {
  const Index count = 4 * (order + 1);
  MatrixXf matrix = MatrixXf::Identity(size, size);
  for (Index k = 0; k < count; ++k) {
    Expansion sum = Expansion::Zero(4, order + 1);
    map(units(0, k), sum);
    matrix.col(k).head(count) = as_vector(sum);
  }
  return matrix;
}

}  // namespace

FarField::FarField(int order, double gauge, double flux_weight)
    : translations_(order),
      units_(1, 4 * (order + 1), order),
      log_gauge_(std::log(gauge)),
      flux_weight_(flux_weight) {
  units_.clear(0);
  for (Index k = 0; k < count(); ++k) units_(0, k)(k % 4, k / 4) = 1.0;
}

MatrixXf FarField::of_densities(const Box& disk, const Curve& curve) const {
  const int order = translations_.order();
  const StressletNodes nodes({curve});
  MatrixXf matrix = MatrixXf::Zero(size(), 2 * curve.size());
  for (Index j = 0; j < curve.size(); ++j) {
    for (Index part = 0; part < 2; ++part) {
      const double ex = part == 0 ? 1.0 : 0.0, ey = 1.0 - ex;
      Expansion sum = Expansion::Zero(4, order + 1);
      p2m(disk,
          {&nodes.x[j], &nodes.y[j], &nodes.nx[j], &nodes.ny[j], &nodes.least2[j], 1, &ex, &ey},
          sum);
      matrix.col(2 * j + part).head(count()) = as_vector(sum);
    }
  }
  return matrix;
}

MatrixXf FarField::of_loads(const Box& disk, Complex centre, double gyration_radius) const {
  const int order = translations_.order();
  const double scale = -4.0 * std::numbers::pi;
  const PointForce loads[] = {{centre, scale, 0.0},
                              {centre, scale * imaginary, 0.0},
                              {centre, 0.0, scale * gyration_radius}};
  MatrixXf matrix = MatrixXf::Zero(size(), 3);
  for (Index k = 0; k < 3; ++k) {
    Expansion sum = Expansion::Zero(4, order + 1);
    p2m(disk, loads[k], sum);
    matrix.col(k).head(count()) = as_vector(sum);
  }
  return matrix;
}

MatrixXf FarField::at_points(const Box& disk, const ComplexVector& points) const {
  MatrixXf matrix = MatrixXf::Zero(2 * points.size(), size());
  const Eigen::VectorXd x = points.real(), y = points.imag();
  for (Index first = 0; first < points.size(); first += VectorGroup::size) {
    const VectorGroup targets = group_of(x, y, first, points.size());
    const Index last = std::min<Index>(first + VectorGroup::size, points.size());
    for (Index k = 0; k < count(); ++k) {
      VectorGroup sum;
      l2p(disk, units_(0, k), targets, sum);
      for (Index i = first; i < last; ++i) {
        const auto lane = static_cast<std::size_t>(i - first);
        matrix(2 * i, k) = static_cast<float>(sum.x[lane]);
        matrix(2 * i + 1, k) = static_cast<float>(sum.y[lane]);
      }
    }
  }
  return matrix;
}

MatrixXf FarField::multipole_to_multipole(const Box& from, const Box& to) const {
  return assembled(units_, translations_.order(), size(), [&](const auto& unit, Expansion& sum) {
    translations_.m2m(from, unit, to, sum);
  });
}

MatrixXf FarField::local_to_local(const Box& from, const Box& to) const {
  return assembled(units_, translations_.order(), size(), [&](const auto& unit, Expansion& sum) {
    translations_.l2l(from, unit, to, sum);
  });
}

MatrixXf FarField::multipole_to_local(const Box& from, const Box& to) const {
  MatrixXf matrix = MatrixXf::Identity(size(), size());
  matrix.topLeftCorner(count(), count()) = translations_.m2l_matrix(from, to).cast<float>();
  // Stokeslets with the gauge length ell differ by -2 A_0 log ell from those with the length 1.
  for (Index part = 0; part < 2; ++part) {
    matrix(part, part) -= static_cast<float>(2.0 * log_gauge_);
  }
  return matrix;
}

Eigen::VectorXf FarField::weights() const {
  Eigen::VectorXf weights(size());
  for (Index k = 0; k < count(); ++k) weights[k] = std::ldexp(1.0F, -static_cast<int>(k / 4));
  if (flux_weight_ > 0.0) weights[count()] = static_cast<float>(flux_weight_);
  return weights;
}

}  // namespace stokesbook
