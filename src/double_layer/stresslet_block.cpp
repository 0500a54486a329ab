// Sums the stresslets (02.6) of a block of nodes: velocities at a group of targets in vector
// registers, and pressure, vorticity and strain at one target.
#include "double_layer/stresslet_block.hpp"

#include <algorithm>
#include <numbers>

#include "double_layer/lanes.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Returns the larger number in each lane.
Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

// Adds the sums of (w / pi) (r.n) (r.eta) r / rho^4 over the nodes, with rho >= w / 2, at two
// registers of targets. The registers share the loads of a node and one division, because the
// division limits the speed of the loop.
template <int fields>
void add_two_registers(const StressletBlock& block, const double* target_x, const double* target_y,
                       int offset, std::array<VectorGroup, fields>& sum) {
  const Lanes x0 = load(target_x), x1 = load(target_x + lane_count);
  const Lanes y0 = load(target_y), y1 = load(target_y + lane_count);
  Lanes u0[fields]{}, v0[fields]{}, u1[fields]{}, v1[fields]{};
  for (Index j = 0; j < block.size; ++j) {
    const Lanes dx0 = x0 - block.x[j], dy0 = y0 - block.y[j];
    const Lanes dx1 = x1 - block.x[j], dy1 = y1 - block.y[j];
    const Lanes least2 = Lanes{} + block.least2[j];
    const Lanes rho2_0 = larger(dx0 * dx0 + dy0 * dy0, least2);
    const Lanes rho2_1 = larger(dx1 * dx1 + dy1 * dy1, least2);
    // 1 / rho_0^2 = rho_1^2 / (rho_0^2 rho_1^2), and the same with 0 and 1 exchanged.
    const Lanes inverse = 1.0 / (rho2_0 * rho2_1);
    const Lanes inverse_0 = rho2_1 * inverse, inverse_1 = rho2_0 * inverse;
    const Lanes c0 = (dx0 * block.nx[j] + dy0 * block.ny[j]) * (inverse_0 * inverse_0);
    const Lanes c1 = (dx1 * block.nx[j] + dy1 * block.ny[j]) * (inverse_1 * inverse_1);
    for (int field = 0; field < fields; ++field) {
      const double ex = block.ex[j + field * block.stride], ey = block.ey[j + field * block.stride];
      const Lanes along_0 = c0 * (dx0 * ex + dy0 * ey), along_1 = c1 * (dx1 * ex + dy1 * ey);
      u0[field] += along_0 * dx0;
      v0[field] += along_0 * dy0;
      u1[field] += along_1 * dx1;
      v1[field] += along_1 * dy1;
    }
  }
  for (int field = 0; field < fields; ++field) {
    const auto f = static_cast<std::size_t>(field);
    double *u = &sum[f].x[0] + offset, *v = &sum[f].y[0] + offset;
    store(load(u) + u0[field], u);
    store(load(v) + v0[field], v);
    store(load(u + lane_count) + u1[field], u + lane_count);
    store(load(v + lane_count) + v1[field], v + lane_count);
  }
}

}  // namespace

StressletNodes::StressletNodes(const std::vector<Curve>& curves) {
  const ComplexVector nodes = all_nodes(curves);
  x = nodes.real();
  y = nodes.imag();
  for (Eigen::VectorXd* array : {&nx, &ny, &least2}) array->resize(nodes.size());
  Index first = 0;
  for (const Curve& curve : curves) {
    const Index m = curve.size();
    const Eigen::VectorXd w = weights(curve);
    const ComplexVector weighted_normal = std::numbers::inv_pi * normals(curve).cwiseProduct(w);
    nx.segment(first, m) = weighted_normal.real();
    ny.segment(first, m) = weighted_normal.imag();
    least2.segment(first, m) = 0.25 * w.array().square();
    first += m;
  }
}

VectorGroup group_of(const Eigen::VectorXd& x, const Eigen::VectorXd& y, Index first, Index last) {
  VectorGroup group;
  for (Index i = 0; i < VectorGroup::size; ++i) {
    const Index point = std::min(first + i, last - 1);
    group.x[static_cast<std::size_t>(i)] = x[point];
    group.y[static_cast<std::size_t>(i)] = y[point];
  }
  return group;
}

template <int fields>
void add_velocities(const StressletBlock& block, const VectorGroup& targets,
                    std::array<VectorGroup, fields>& sum) {
  for (int offset = 0; offset < VectorGroup::size; offset += 2 * lane_count) {
    add_two_registers<fields>(block, &targets.x[0] + offset, &targets.y[0] + offset, offset, sum);
  }
}

template void add_velocities<1>(const StressletBlock&, const VectorGroup&,
                                std::array<VectorGroup, 1>&);
template void add_velocities<2>(const StressletBlock&, const VectorGroup&,
                                std::array<VectorGroup, 2>&);
template void add_velocities<4>(const StressletBlock&, const VectorGroup&,
                                std::array<VectorGroup, 4>&);

void add_derivatives(const StressletBlock& block, Complex target, FlowDerivatives& sum) {
  const double zx = target.real(), zy = target.imag();
  const double *x = block.x, *y = block.y, *nx = block.nx, *ny = block.ny;
  const double *ex = block.ex, *ey = block.ey, *least2 = block.least2;
  const Index size = block.size;
  double pressure = 0.0, vorticity = 0.0, strain_x = 0.0, strain_y = 0.0;
#pragma omp simd reduction(+ : pressure, vorticity, strain_x, strain_y)
  for (Index j = 0; j < size; ++j) {
    // With a = n eta, b = n.eta and c = 1 / conj(r), n times w / pi: the pressure is
    // Re(a conj(c)^2), the vorticity -Im(a conj(c)^2), and the strain -c^2 (b + conj(a) r c).
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
