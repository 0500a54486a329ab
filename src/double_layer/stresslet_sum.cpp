#include "double_layer/stresslet_sum.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_block.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Sources that are summed before they join the others' sum: rounding grows with the square roots of
// their number and of the number of blocks.
constexpr Index block_size = 512;

// Targets from the first on; the last of all is repeated where they do not fill the group.
VectorGroup group_of(const ComplexVector& targets, Index first) {
  VectorGroup group;
  for (Index i = 0; i < VectorGroup::size; ++i) {
    const Complex target = targets[std::min(first + i, targets.size() - 1)];
    group.x[static_cast<std::size_t>(i)] = target.real();
    group.y[static_cast<std::size_t>(i)] = target.imag();
  }
  return group;
}

}  // namespace

StressletSum::StressletSum(const std::vector<Curve>& curves, KernelStorage storage) {
  Index n = 0;
  for (const Curve& curve : curves) {
    n += curve.size();
  }
  for (Eigen::VectorXd* array : {&x_, &y_, &nx_, &ny_, &least2_}) {
    array->resize(n);
  }
  Index first = 0;
  for (const Curve& curve : curves) {
    const Index m = curve.size();
    const Eigen::VectorXd w = weights(curve);
    const ComplexVector weighted_normal = std::numbers::inv_pi * normals(curve).cwiseProduct(w);
    x_.segment(first, m) = curve.x.real();
    y_.segment(first, m) = curve.x.imag();
    nx_.segment(first, m) = weighted_normal.real();
    ny_.segment(first, m) = weighted_normal.imag();
    least2_.segment(first, m) = 0.25 * w.array().square();
    first += m;
  }
  if (storage == KernelStorage::stored) matrix_ = matrix(nodes());
}

ComplexVector StressletSum::nodes() const {
  ComplexVector z(size());
  z.real() = x_;
  z.imag() = y_;
  return z;
}

Eigen::MatrixXd StressletSum::matrix(const ComplexVector& targets) const {
  const Index m = targets.size(), n = size();
  Eigen::MatrixXd result(2 * m, 2 * n);
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < m; ++i) {
      const Eigen::Vector2d r{targets[i].real() - x_[j], targets[i].imag() - y_[j]};
      const double rho2 = std::max(r.squaredNorm(), least2_[j]);
      const double factor = (r[0] * nx_[j] + r[1] * ny_[j]) / (rho2 * rho2);
      result.block<2, 2>(2 * i, 2 * j) = factor * r * r.transpose();
    }
  }
  return result;
}

ComplexVector StressletSum::operator()(const ComplexVector& density) const {
  return matrix_.size() > 0 ? deinterleaved(matrix_ * interleaved(density))
                            : (*this)(nodes(), density);
}

ComplexVector StressletSum::operator()(const ComplexVector& targets,
                                       const ComplexVector& density) const {
  const Eigen::VectorXd ex = density.real(), ey = density.imag();
  const Index m = targets.size(), n = size();
  ComplexVector velocity(m);
  // A thread owns its targets and sums their sources in order: the same bits for any number of
  // threads.
#pragma omp parallel for schedule(static)
  for (Index group = 0; group < m; group += VectorGroup::size) {
    const VectorGroup points = group_of(targets, group);
    std::array<VectorGroup, 1> sum{};
    for (Index first = 0; first < n; first += block_size) {
      add_velocities<1>({&x_[first], &y_[first], &nx_[first], &ny_[first], &least2_[first],
                         std::min(block_size, n - first), &ex[first], &ey[first]},
                        points, sum);
    }
    for (Index i = group; i < std::min(group + VectorGroup::size, m); ++i) {
      const auto lane = static_cast<std::size_t>(i - group);
      velocity[i] = {sum[0].x[lane], sum[0].y[lane]};
    }
  }
  return velocity;
}

std::vector<FlowDerivatives> StressletSum::derivatives(const ComplexVector& targets,
                                                       const ComplexVector& density) const {
  const Eigen::VectorXd ex = density.real(), ey = density.imag();
  const Index m = targets.size();
  std::vector<FlowDerivatives> flow(static_cast<std::size_t>(m));
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < m; ++i) {
    add_derivatives({x_.data(), y_.data(), nx_.data(), ny_.data(), least2_.data(), size(),
                     ex.data(), ey.data()},
                    targets[i], flow[static_cast<std::size_t>(i)]);
  }
  return flow;
}

KernelStorage StressletSum::automatic_storage(Index n_nodes) {
  constexpr Index break_even = 192;
  return n_nodes <= break_even ? KernelStorage::stored : KernelStorage::streamed;
}

}  // namespace stokesbook
