#include "double_layer/stresslet_block.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Adds the velocities at two targets, which share the division that limits the loop.
void add_velocities(const StressletBlock& s, Complex target_0, Complex target_1, Complex& sum_0,
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

void add_velocities(const StressletBlock& block, const ComplexVector& targets, Index first,
                    Index last, ComplexVector& sum) {
  for (Index i = first; i + 1 < last; i += 2) {
    add_velocities(block, targets[i], targets[i + 1], sum[i], sum[i + 1]);
  }
  if ((last - first) % 2 != 0) {
    Complex unused{};
    add_velocities(block, targets[last - 1], targets[last - 1], sum[last - 1], unused);
  }
}

void add_derivatives(const StressletBlock& block, Complex target, FlowDerivatives& sum) {
  const double zx = target.real(), zy = target.imag();
  const double *x = block.x, *y = block.y, *nx = block.nx, *ny = block.ny;
  const double *ex = block.ex, *ey = block.ey, *least2 = block.least2;
  const Index size = block.size;
  double pressure = 0.0, vorticity = 0.0, strain_x = 0.0, strain_y = 0.0;
#pragma omp simd reduction(+ : pressure, vorticity, strain_x, strain_y)
  for (Index j = 0; j < size; ++j) {
    // With a = n eta, b = n.eta and c = 1 / conj(r): a / r^2 = a conj(c)^2, and the strain is
    // -c^2 (b + conj(a) r c).
    const double ax = nx[j] * ex[j] - ny[j] * ey[j], ay = nx[j] * ey[j] + ny[j] * ex[j];
    const double b = nx[j] * ex[j] + ny[j] * ey[j];
    const double dx = zx - x[j], dy = zy - y[j];
    const double distance2 = dx * dx + dy * dy;
    const double inverse = 1.0 / (distance2 > least2[j] ? distance2 : least2[j]);
    const double cx = dx * inverse, cy = dy * inverse;
    const double c2x = cx * cx - cy * cy, c2y = 2.0 * cx * cy;
    pressure += ax * c2x + ay * c2y;
    vorticity += ax * c2y - ay * c2x;
    const double rcx = dx * cx - dy * cy, rcy = dx * cy + dy * cx;
    const double gx = b + ax * rcx + ay * rcy, gy = ax * rcy - ay * rcx;
    strain_x -= c2x * gx - c2y * gy;
    strain_y -= c2x * gy + c2y * gx;
  }
  sum += {pressure, vorticity, {strain_x, strain_y}};
}

}  // namespace stokesbook
