#include "double_layer/stresslet_sum.hpp"

#include <algorithm>
#include <numbers>

#include "double_layer/double_layer.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Sources that fit the first-level cache while a block of targets passes over them.
constexpr Index block_size = 512;

// Targets a thread takes at a time.
constexpr Index chunk_size = 64;

struct SourceBlock {
  const double *x, *y, *nx, *ny, *ex, *ey, *least2;
  Index size;
};

// Adds the block's velocities at two targets; the two share one division, which is what limits the
// loop.
void add_velocities(const SourceBlock& s, Complex target_0, Complex target_1, Complex& sum_0,
                    Complex& sum_1) {
  const double x0 = target_0.real(), y0 = target_0.imag();
  const double x1 = target_1.real(), y1 = target_1.imag();
  // Copies that no store can alias: through the struct the compiler would gather.
  const double *x = s.x, *y = s.y, *nx = s.nx, *ny = s.ny, *ex = s.ex, *ey = s.ey;
  const double* least2 = s.least2;
  const Index size = s.size;
  double u0 = 0.0, v0 = 0.0, u1 = 0.0, v1 = 0.0;
#pragma omp simd reduction(+ : u0, v0, u1, v1)
  for (Index j = 0; j < size; ++j) {
    const double dx0 = x0 - x[j], dy0 = y0 - y[j];
    const double dx1 = x1 - x[j], dy1 = y1 - y[j];
    const double distance2_0 = dx0 * dx0 + dy0 * dy0;
    const double distance2_1 = dx1 * dx1 + dy1 * dy1;
    const double rho2_0 = distance2_0 > least2[j] ? distance2_0 : least2[j];
    const double rho2_1 = distance2_1 > least2[j] ? distance2_1 : least2[j];
    const double inverse = 1.0 / (rho2_0 * rho2_1);
    const double inverse_0 = rho2_1 * inverse, inverse_1 = rho2_0 * inverse;
    const double c0 =
        (dx0 * nx[j] + dy0 * ny[j]) * (dx0 * ex[j] + dy0 * ey[j]) * (inverse_0 * inverse_0);
    const double c1 =
        (dx1 * nx[j] + dy1 * ny[j]) * (dx1 * ex[j] + dy1 * ey[j]) * (inverse_1 * inverse_1);
    u0 += c0 * dx0;
    v0 += c0 * dy0;
    u1 += c1 * dx1;
    v1 += c1 * dy1;
  }
  sum_0 += Complex{u0, v0};
  sum_1 += Complex{u1, v1};
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
  ComplexVector velocity = ComplexVector::Zero(m);
  // A thread owns its targets and sums their sources in order: the same bits for any number of
  // threads.
#pragma omp parallel for schedule(static)
  for (Index chunk = 0; chunk < m; chunk += chunk_size) {
    const Index last = std::min(chunk + chunk_size, m);
    for (Index first = 0; first < n; first += block_size) {
      const SourceBlock sources{
          &x_[first], &y_[first], &nx_[first],     &ny_[first],
          &ex[first], &ey[first], &least2_[first], std::min(block_size, n - first)};
      for (Index i = chunk; i + 1 < last; i += 2) {
        add_velocities(sources, targets[i], targets[i + 1], velocity[i], velocity[i + 1]);
      }
      if ((last - chunk) % 2 != 0) {
        Complex unused{};
        add_velocities(sources, targets[last - 1], targets[last - 1], velocity[last - 1], unused);
      }
    }
  }
  return velocity;
}

std::vector<FlowDerivatives> StressletSum::derivatives(const ComplexVector& targets,
                                                       const ComplexVector& density) const {
  // With a = n eta and b = n.eta, weights included, and c = 1 / conj(r): a / r^2 = a conj(c)^2, and
  // the strain is -c^2 (b + conj(a) r c).
  const Eigen::ArrayXd ax = nx_.array() * density.real().array() -
                            ny_.array() * density.imag().array(),
                       ay = nx_.array() * density.imag().array() +
                            ny_.array() * density.real().array(),
                       b = nx_.array() * density.real().array() +
                           ny_.array() * density.imag().array();
  const Index m = targets.size(), n = size();
  std::vector<FlowDerivatives> flow(static_cast<std::size_t>(m));
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < m; ++i) {
    const double zx = targets[i].real(), zy = targets[i].imag();
    const double *x = x_.data(), *y = y_.data(), *least2 = least2_.data();
    const double *source_x = ax.data(), *source_y = ay.data(), *source_b = b.data();
    double pressure = 0.0, vorticity = 0.0, strain_x = 0.0, strain_y = 0.0;
#pragma omp simd reduction(+ : pressure, vorticity, strain_x, strain_y)
    for (Index j = 0; j < n; ++j) {
      const double dx = zx - x[j], dy = zy - y[j];
      const double distance2 = dx * dx + dy * dy;
      const double inverse = 1.0 / (distance2 > least2[j] ? distance2 : least2[j]);
      const double cx = dx * inverse, cy = dy * inverse;
      const double c2x = cx * cx - cy * cy, c2y = 2.0 * cx * cy;
      pressure += source_x[j] * c2x + source_y[j] * c2y;
      vorticity += source_x[j] * c2y - source_y[j] * c2x;
      const double rcx = dx * cx - dy * cy, rcy = dx * cy + dy * cx;
      const double gx = source_b[j] + source_x[j] * rcx + source_y[j] * rcy;
      const double gy = source_x[j] * rcy - source_y[j] * rcx;
      strain_x -= c2x * gx - c2y * gy;
      strain_y -= c2x * gy + c2y * gx;
    }
    flow[static_cast<std::size_t>(i)] = {pressure, vorticity, {strain_x, strain_y}};
  }
  return flow;
}

KernelStorage StressletSum::automatic_storage(Index n_nodes) {
  constexpr Index break_even = 192;
  return n_nodes <= break_even ? KernelStorage::stored : KernelStorage::streamed;
}

}  // namespace stokesbook
