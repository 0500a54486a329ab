#pragma once

#include <cmath>
#include <numbers>

#include "support/walls.hpp"

namespace stokesbook::test {

/// Describes two circles, one inside the other, with their motions about their own centres.
struct EccentricAnnulus {
  double inner_radius, outer_radius;
  Complex inner_centre, outer_centre;  ///< must differ
  RigidMotion inner, outer;
};

/// Returns the load of the inner circle on the fluid, about its own centre, in closed form
/// (Jeffery, Wannier). The distance of the centres is e, the y axis points towards the outer
/// centre, and W and V are the relative velocities along x and y:
/// tau = arccosh((R1^2 + R2^2 - e^2) / (2 R1 R2)),
/// s = R1 R2 sinh(tau) / e, d1 = (R2^2 - R1^2 - e^2) / (2 e),
/// f = [(R1^2 + R2^2) W - e (w1 R1^2 + w2 R2^2)] / [2 tau (R1^2 + R2^2) - 4 s e],
/// E = (2 tau f - W) / (2 e),
/// A = -coth(tau) [w2 R2^2 - w1 R1^2 + 2 (R2^2 - R1^2) E] / 4,
/// F_x = 8 pi mu f, F_y = 4 pi mu V / (tau - tanh tau), L = 8 pi mu (A + f d1).
/// The terms cancel if the gap is small, so the formula is evaluated in long double.
inline Load inner_load(const EccentricAnnulus& annulus, double mu) {
  using Real = long double;
  const Complex to_outer = annulus.outer_centre - annulus.inner_centre;
  const Real e = std::abs(to_outer), r1 = annulus.inner_radius, r2 = annulus.outer_radius;
  const Complex y = to_outer / std::abs(to_outer), x = -imaginary * y;
  const Complex relative = annulus.inner.velocity - annulus.outer.velocity;
  const Real w = dot(relative, x), v = dot(relative, y);
  const Real w1 = annulus.inner.omega, w2 = annulus.outer.omega;
  const Real sum = r1 * r1 + r2 * r2, difference = r2 * r2 - r1 * r1;
  // cosh(tau) - 1 is the product of the least and the greatest gap, divided by 2 R1 R2.
  const Real excess = (r2 - r1 - e) * (r2 - r1 + e) / (2 * r1 * r2);
  const Real sinh_tau = std::sqrt(excess * (excess + 2)), tau = std::asinh(sinh_tau);
  const Real s = r1 * r2 * sinh_tau / e, d1 = (difference - e * e) / (2 * e);
  const Real f = (sum * w - e * (w1 * r1 * r1 + w2 * r2 * r2)) / (2 * tau * sum - 4 * s * e);
  const Real big_e = (2 * tau * f - w) / (2 * e);
  const Real a = -(w2 * r2 * r2 - w1 * r1 * r1 + 2 * difference * big_e) / (4 * std::tanh(tau));
  const Real scale = 8 * std::numbers::pi_v<Real> * static_cast<Real>(mu);
  const auto fx = static_cast<double>(scale * f);
  const auto fy = static_cast<double>(scale * v / (2 * (tau - std::tanh(tau))));
  return {fx * x + fy * y, static_cast<double>(scale * (a + f * d1))};
}

/// Returns the bounded problem of the two circles. Component 0 is the inner circle, and component 1
/// is the outer circle.
inline StokesProblem annulus_problem(const EccentricAnnulus& annulus, double mu,
                                     Eigen::Index inner_nodes, Eigen::Index outer_nodes) {
  const Circle inner{annulus.inner_radius}, outer{annulus.outer_radius};
  return {{held_body(inner, inner_nodes, {annulus.inner_centre}, annulus.inner),
           enclosing_wall(outer, outer_nodes, {annulus.outer_centre}, annulus.outer)},
          mu,
          {},
          {}};
}

}  // namespace stokesbook::test
