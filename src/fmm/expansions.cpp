// Forms multipole expansions of nodes and point forces (P2M) by (08.6), and evaluates velocities
// and derivatives of local expansions (L2P) by (08.7) and (08.5).
#include "fmm/expansions.hpp"

#include <algorithm>
#include <numbers>

#include "double_layer/lanes.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

Coefficients coefficients(Complex phi, Complex psi) {
  return {phi.real(), phi.imag(), psi.real(), psi.imag()};
}

// Adds the velocities of a local expansion at one register of targets. Horner's rule evaluates phi
// and psi, and phi' from the partial results for phi.
void add_to_register(const Box& box, Eigen::Ref<const Expansion> expansion, const double* target_x,
                     const double* target_y, double* u, double* v) {
  const Lanes x = (load(target_x) - box.centre.real()) / box.radius;
  const Lanes y = (load(target_y) - box.centre.imag()) / box.radius;
  Lanes phi_x{}, phi_y{}, slope_x{}, slope_y{}, psi_x{}, psi_y{};
  for (Index l = expansion.cols() - 1; l >= 0; --l) {
    const double* c = expansion.col(l).data();
    const Lanes slope = slope_x * x - slope_y * y + phi_x;
    slope_y = slope_x * y + slope_y * x + phi_y;
    slope_x = slope;
    const Lanes phi = phi_x * x - phi_y * y + c[0];
    phi_y = phi_x * y + phi_y * x + c[1];
    phi_x = phi;
    const Lanes psi = psi_x * x - psi_y * y + c[2];
    psi_y = psi_x * y + psi_y * x + c[3];
    psi_x = psi;
  }
  // u = phi - w conj(dphi/dw) - conj(psi) with w = (z - c) / R (08.5)
  store(load(u) + (phi_x - (x * slope_x + y * slope_y) - psi_x), u);
  store(load(v) + (phi_y - (y * slope_x - x * slope_y) + psi_y), v);
}

}  // namespace

void p2m(const Box& box, const StressletBlock& nodes, Eigen::Ref<Expansion> sum) {
  constexpr Index chunk = 64;  // nodes at a time, so that their powers stay in the fast cache
  std::array<double, chunk> wx, wy, ax, ay, b, gx, gy, px, py, qx, qy;
  const double inverse = 1.0 / box.radius;
  for (Index first = 0; first < nodes.size; first += chunk) {
    const auto count = static_cast<std::size_t>(std::min(chunk, nodes.size - first));
    for (std::size_t j = 0; j < count; ++j) {
      const Index i = first + static_cast<Index>(j);
      const double nx = nodes.nx[i], ny = nodes.ny[i], ex = nodes.ex[i], ey = nodes.ey[i];
      wx[j] = (nodes.x[i] - box.centre.real()) * inverse;
      wy[j] = (nodes.y[i] - box.centre.imag()) * inverse;
      // nx + i ny is n w / pi: a = n eta w / (4 pi), b = n.eta w / (2 pi)
      ax[j] = 0.25 * (nx * ex - ny * ey);
      ay[j] = 0.25 * (nx * ey + ny * ex);
      b[j] = 0.5 * (nx * ex + ny * ey);
      gx[j] = ax[j] * wx[j] + ay[j] * wy[j];  // a conj(W)
      gy[j] = ay[j] * wx[j] - ax[j] * wy[j];
      px[j] = 1.0;  // W^(k-1)
      py[j] = 0.0;
      qx[j] = 0.0;  // W^(k-2)
      qy[j] = 0.0;
    }
    // R A_k = sum a W^(k-1), R B_k = sum (k-1) a conj(W) W^(k-2) - b W^(k-1) (08.6)
    for (Index k = 1; k < sum.cols(); ++k) {
      const auto factor = static_cast<double>(k - 1);
      double phi_x = 0.0, phi_y = 0.0, psi_x = 0.0, psi_y = 0.0;
#pragma omp simd reduction(+ : phi_x, phi_y, psi_x, psi_y)
      for (std::size_t j = 0; j < count; ++j) {
        phi_x += ax[j] * px[j] - ay[j] * py[j];
        phi_y += ax[j] * py[j] + ay[j] * px[j];
        psi_x += factor * (gx[j] * qx[j] - gy[j] * qy[j]) - b[j] * px[j];
        psi_y += factor * (gx[j] * qy[j] + gy[j] * qx[j]) - b[j] * py[j];
        qx[j] = px[j];
        qy[j] = py[j];
        px[j] = qx[j] * wx[j] - qy[j] * wy[j];
        py[j] = qx[j] * wy[j] + qy[j] * wx[j];
      }
      sum.col(k) += inverse * Coefficients{phi_x, phi_y, psi_x, psi_y};
    }
  }
}

void p2m(const Box& box, const PointForce& point, Eigen::Ref<Expansion> sum) {
  constexpr double scale = 0.25 * std::numbers::inv_pi;
  const Complex f = scale * point.force;
  const Complex w = (point.position - box.centre) / box.radius;
  // A_k = f W^k / (2k), B_k = turning W^(k-1) - conj(f) W^k / (2k)
  const Complex turning = std::conj(w) * 0.5 * f + imaginary * (scale * point.torque / box.radius);
  sum.col(0) += coefficients(-0.5 * f, 0.5 * std::conj(f));
  Complex power = 1.0;  // W^(k-1)
  for (Index k = 1; k < sum.cols(); ++k) {
    const Complex term = power * w / static_cast<double>(2 * k);
    sum.col(k) += coefficients(f * term, turning * power - std::conj(f) * term);
    power *= w;
  }
}

void l2p(const Box& box, Eigen::Ref<const Expansion> expansion, const VectorGroup& targets,
         VectorGroup& sum) {
  for (int lane = 0; lane < VectorGroup::size; lane += lane_count) {
    add_to_register(box, expansion, &targets.x[0] + lane, &targets.y[0] + lane, &sum.x[0] + lane,
                    &sum.y[0] + lane);
  }
}

// Pressure -4 Re phi', vorticity 4 Im phi' and strain -2 conj(conj(z - c) phi'' + psi') (07.4),
// with derivatives with respect to w = (z - c) / R by Horner's rule.
FlowDerivatives l2p_derivatives(const Box& box, Eigen::Ref<const Expansion> expansion,
                                Complex target) {
  const Complex w = (target - box.centre) / box.radius;
  Complex phi{}, slope{}, curvature{}, psi{}, psi_slope{};
  for (Index l = expansion.cols() - 1; l >= 0; --l) {
    curvature = curvature * w + 2.0 * slope;
    slope = slope * w + phi;
    phi = phi * w + Complex{expansion(0, l), expansion(1, l)};
    psi_slope = psi_slope * w + psi;
    psi = psi * w + Complex{expansion(2, l), expansion(3, l)};
  }
  const Complex strain = std::conj(w) * curvature + psi_slope;
  return {-4.0 * slope.real() / box.radius, 4.0 * slope.imag() / box.radius,
          -2.0 / box.radius * std::conj(strain)};
}

}  // namespace stokesbook
