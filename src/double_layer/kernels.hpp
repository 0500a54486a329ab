#pragma once

#include <cmath>
#include <numbers>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Evaluates the stresslet \f$ \frac1\pi \frac{(r\cdot n)(r\cdot\eta)}{\rho^4} r \f$ with
/// \f$ \rho = |r| \f$: the velocity of the double layer (02.6) per unit length of curve.
///
/// @param  r    target minus source, length, not zero
/// @param  n    unit normal at the source, out of the fluid
/// @param  eta  density at the source, length / time
/// @return      velocity per length, 1 / time
inline Complex stresslet(Complex r, Complex n, Complex eta) {
  const double rho2 = std::norm(r);
  return std::numbers::inv_pi * dot(r, n) * dot(r, eta) / (rho2 * rho2) * r;
}

/// Evaluates the Stokeslet (02.2),
/// \f$ \frac{1}{4\pi\mu}\left[-\log\frac{\rho}{\ell} F + \frac{r (r\cdot F)}{\rho^2}\right] \f$.
///
/// @param  r      target minus source, length, not zero
/// @param  force  F on the fluid, force / length
/// @param  mu     viscosity, force time / length^2
/// @param  ell    gauge length: the radius at which the logarithm vanishes
/// @return        velocity, length / time
inline Complex stokeslet(Complex r, Complex force, double mu, double ell) {
  const double rho_squared = std::norm(r);
  return (-0.5 * std::log(rho_squared / (ell * ell)) * force + r * (dot(r, force) / rho_squared)) /
         (4.0 * std::numbers::pi * mu);
}

/// Evaluates the rotlet (02.12), \f$ \frac{L\, r^\perp}{4\pi\mu\rho^2} \f$.
///
/// @param  torque  L, counter-clockwise, on the fluid, force; units are otherwise as in stokeslet()
inline Complex rotlet(Complex r, double torque, double mu) {
  return perp(r) * (torque / (4.0 * std::numbers::pi * mu * std::norm(r)));
}

}  // namespace stokesbook
