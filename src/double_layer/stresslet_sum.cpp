#include "double_layer/stresslet_sum.hpp"

#include <algorithm>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_block.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Sources that fit the first-level cache while a block of targets passes over them.
constexpr Index block_size = 512;

// Targets a thread takes at a time.
constexpr Index chunk_size = 64;

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
  ComplexVector velocity = ComplexVector::Zero(m);
  // A thread owns its targets and sums their sources in order: the same bits for any number of
  // threads.
#pragma omp parallel for schedule(static)
  for (Index chunk = 0; chunk < m; chunk += chunk_size) {
    const Index last = std::min(chunk + chunk_size, m);
    for (Index first = 0; first < n; first += block_size) {
      add_velocities({&x_[first], &y_[first], &nx_[first], &ny_[first], &ex[first], &ey[first],
                      &least2_[first], std::min(block_size, n - first)},
                     targets, chunk, last, velocity);
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
    add_derivatives({x_.data(), y_.data(), nx_.data(), ny_.data(), ex.data(), ey.data(),
                     least2_.data(), size()},
                    targets[i], flow[static_cast<std::size_t>(i)]);
  }
  return flow;
}

KernelStorage StressletSum::automatic_storage(Index n_nodes) {
  constexpr Index break_even = 192;
  return n_nodes <= break_even ? KernelStorage::stored : KernelStorage::streamed;
}

}  // namespace stokesbook
