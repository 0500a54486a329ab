#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "double_layer/flow_derivatives.hpp"
#include "fmm/expansions.hpp"
#include "periodic/lattice.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::test {

/// Periodic functions of the vector z from a source to a target, whose singular parts are
/// \f$ f = 1/z,\ p = 1/z^2,\ g = \bar z/z^2,\ l = -\log|z|,\ h = \frac{z}{2\bar z} \f$. Each has
/// the mean zero over a cell.
struct PeriodicFunctions {
  double l = 0.0;
  Complex h, f, p, g, g_slope;  // p = -df/dz, g_slope = dg/dz
};

/// Evaluates the functions by an Ewald sum (Hasimoto), which shares no formula with the library: a
/// sum over the lattice, and one over the dual lattice.
///
/// @param  splitting  moves work from one sum to the other; the result does not depend on it
inline PeriodicFunctions ewald_functions(const Lattice& lattice, Complex z,
                                         double splitting = 1.0) {
  using std::numbers::pi;
  const double area = lattice.area(), xi2 = splitting * pi / area;
  constexpr double digits = 42.0;
  PeriodicFunctions sum;
  Complex slope, curvature;  // derivatives of h with respect to conj(z)
  std::vector<Complex> images = {0.0};
  for (const Complex w : lattice.half_disk(std::sqrt(digits / xi2) + std::abs(z))) {
    images.insert(images.end(), {w, -w});
  }
  for (const Complex w : images) {
    const Complex r = z - w, conjugate = std::conj(r);
    const double s = xi2 * std::norm(r);
    if (s > digits) continue;
    const double e = std::exp(-s);
    sum.l += 0.5 * (-std::expint(-s) - e);
    sum.h += 0.5 * e * r / conjugate;
    sum.f += e / r;
    sum.p += e * (1.0 / r + xi2 * conjugate) / r;
    slope -= 0.5 * e * (1.0 + s) * r / conjugate / conjugate;
    curvature += 0.5 * e * (2.0 + 2.0 * s + s * s) * r / conjugate / conjugate / conjugate;
  }
  // Wave vectors are k = 2 pi i w / V; those of w and -w contribute the same.
  for (const Complex w : lattice.half_disk(std::sqrt(4.0 * digits * xi2) * area / (2.0 * pi))) {
    const Complex k = 2.0 * pi / area * imaginary * w, conjugate = std::conj(k);
    const double k2 = std::norm(k), e = 4.0 * pi / area * std::exp(-0.25 * k2 / xi2);
    const double g = (1.0 + 0.25 * k2 / xi2) * e / k2;
    const double cosine = std::cos(dot(k, z)), sine = std::sin(dot(k, z));
    sum.l += g * cosine;
    sum.h -= g * cosine * k / conjugate;
    sum.f += e * sine / k;
    sum.p -= 0.5 * e * cosine * conjugate / k;
    slope += 0.5 * g * sine * k * k / conjugate;
    curvature += 0.25 * g * cosine * k * k * k / conjugate;
  }
  sum.g = -2.0 * std::conj(slope);
  sum.g_slope = -2.0 * std::conj(curvature);
  return sum;
}

/// Double-layer nodes with their density, and points with forces and torques over the viscosity, in
/// the cells of a lattice.
struct PeriodicSources {
  Lattice lattice;
  Curve curve;
  ComplexVector density;
  std::vector<PointForce> points;
  Complex centre;  ///< any point near the sources

  /// Returns \f$ \sum w n\cdot\eta \f$.
  double net_source() const {
    const Eigen::VectorXd w = weights(curve);
    const ComplexVector n = normals(curve);
    double sum = 0.0;
    for (Eigen::Index j = 0; j < curve.size(); ++j) sum += w[j] * dot(n[j], density[j]);
    return sum;
  }

  /// Evaluates the velocity, whose mean is zero if the double layer of a rigid motion counts as
  /// this motion inside its body.
  Complex velocity(Complex z) const {
    const Eigen::VectorXd w = weights(curve);
    const ComplexVector n = normals(curve);
    Complex sum;
    for (Eigen::Index j = 0; j < curve.size(); ++j) {
      const Complex a = w[j] * n[j] * density[j];
      const double b = 2.0 * w[j] * dot(n[j], density[j]);
      const PeriodicFunctions at = ewald_functions(lattice, z - curve.x[j]);
      sum += a * at.f + b * std::conj(at.f) + std::conj(a * at.g) -
             2.0 * std::numbers::pi / lattice.area() * b * (curve.x[j] - centre);
    }
    for (const PointForce& point : points) {
      const PeriodicFunctions at = ewald_functions(lattice, z - point.position);
      sum += point.force * at.l + std::conj(point.force) * at.h +
             imaginary * point.torque * std::conj(at.f);
    }
    return sum / (4.0 * std::numbers::pi);
  }

  /// Evaluates the derivatives of the velocity. The pressure consists of periodic functions with
  /// the mean zero, and of \f$ F\cdot(z - c)/V \f$ for each force F at c.
  FlowDerivatives derivatives(Complex z) const {
    using std::numbers::inv_pi;
    const Eigen::VectorXd w = weights(curve);
    const ComplexVector n = normals(curve);
    const double area = lattice.area();
    FlowDerivatives sum;
    for (Eigen::Index j = 0; j < curve.size(); ++j) {
      const Complex a = w[j] * n[j] * density[j];
      const double b = 2.0 * w[j] * dot(n[j], density[j]);
      const PeriodicFunctions at = ewald_functions(lattice, z - curve.x[j]);
      sum += {inv_pi * (a * at.p).real(), -inv_pi * (a * at.p).imag(),
              0.5 * inv_pi * (std::conj(a * at.g_slope - b * at.p) - std::numbers::pi / area * a)};
    }
    for (const PointForce& point : points) {
      const Complex r = z - point.position;
      const PeriodicFunctions at = ewald_functions(lattice, r);
      const Complex slope = 0.5 * inv_pi * point.force * at.f;
      sum += {slope.real() + dot(point.force, r) / area, -slope.imag() - 0.5 * point.torque / area,
              -0.25 * inv_pi *
                  (point.force * std::conj(at.f) + std::conj(point.force * at.g) +
                   2.0 * imaginary * point.torque * std::conj(at.p))};
    }
    return sum;
  }
};

}  // namespace stokesbook::test
