// Evaluates the trapezoid sum of the double layer (02.6) over all pairs of nodes and targets, in
// blocks of nodes and groups of targets, or as a stored matrix.
#include "double_layer/stresslet_sum.hpp"

#include <algorithm>
#include <array>

#include "double_layer/double_layer.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Number of sources in a block, whose sum is complete before it is added to that of all blocks.
// Rounding grows with the square root of this number, and with that of the number of blocks.
constexpr Index block_size = 512;

}  // namespace

StressletSum::StressletSum(const std::vector<Curve>& curves, KernelStorage storage)
    : nodes_(curves) {
  if (storage == KernelStorage::stored) matrix_ = matrix(positions());
}

ComplexVector StressletSum::positions() const {
  ComplexVector z(size());
  z.real() = nodes_.x;
  z.imag() = nodes_.y;
  return z;
}

Eigen::MatrixXd StressletSum::matrix(const ComplexVector& targets) const {
  const Index m = targets.size(), n = size();
  Eigen::MatrixXd result(2 * m, 2 * n);
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < m; ++i) {
      const Eigen::Vector2d r{targets[i].real() - nodes_.x[j], targets[i].imag() - nodes_.y[j]};
      // (w / pi) (r.n) r r^T / rho^4 with rho >= w / 2.
      const double rho2 = std::max(r.squaredNorm(), nodes_.least2[j]);
      const double factor = (r[0] * nodes_.nx[j] + r[1] * nodes_.ny[j]) / (rho2 * rho2);
      result.block<2, 2>(2 * i, 2 * j) = factor * r * r.transpose();
    }
  }
  return result;
}

ComplexVector StressletSum::operator()(const ComplexVector& density) const {
  return matrix_.size() > 0 ? deinterleaved(matrix_ * interleaved(density))
                            : (*this)(positions(), density);
}

ComplexVector StressletSum::operator()(const ComplexVector& targets,
                                       const ComplexVector& density) const {
  const Eigen::VectorXd x = targets.real(), y = targets.imag();
  const Eigen::VectorXd ex = density.real(), ey = density.imag();
  const Index m = targets.size(), n = size();
  ComplexVector velocity(m);
  // Each thread owns its targets and sums over the sources in order, so that the result is the same
  // to the last bit for any number of threads.
#pragma omp parallel for schedule(static)
  for (Index group = 0; group < m; group += VectorGroup::size) {
    const VectorGroup points = group_of(x, y, group, m);
    std::array<VectorGroup, 1> sum{};
    for (Index first = 0; first < n; first += block_size) {
      add_velocities<1>(
          {&nodes_.x[first], &nodes_.y[first], &nodes_.nx[first], &nodes_.ny[first],
           &nodes_.least2[first], std::min(block_size, n - first), &ex[first], &ey[first]},
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
    add_derivatives({nodes_.x.data(), nodes_.y.data(), nodes_.nx.data(), nodes_.ny.data(),
                     nodes_.least2.data(), size(), ex.data(), ey.data()},
                    targets[i], flow[static_cast<std::size_t>(i)]);
  }
  return flow;
}

KernelStorage StressletSum::automatic_storage(Index n_nodes) {
  constexpr Index break_even = 192;
  return n_nodes <= break_even ? KernelStorage::stored : KernelStorage::streamed;
}

}  // namespace stokesbook
