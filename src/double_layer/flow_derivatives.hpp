#pragma once

#include <numbers>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Pressure, vorticity and strain of a Stokes flow at a point.
///
/// If the velocity is \f$ u = \phi - z\overline{\phi'} - \overline{\psi} \f$ with analytic
/// functions \f$ \phi, \psi \f$, the members are \f$ -4\,\mathrm{Re}\,\phi' \f$,
/// \f$ 4\,\mathrm{Im}\,\phi' \f$ and \f$ 2\,\partial u/\partial\bar z \f$.
struct FlowDerivatives {
  double pressure = 0.0;   ///< pressure over viscosity, 1 / time
  double vorticity = 0.0;  ///< \f$ \partial_1 u_2 - \partial_2 u_1 \f$, 1 / time
  Complex strain;          ///< \f$ e_{11} - e_{22} + 2ie_{12} \f$ of the rate of strain, 1 / time

  /// Adds the derivatives of another flow at the same point.
  FlowDerivatives& operator+=(const FlowDerivatives& other) {
    pressure += other.pressure;
    vorticity += other.vorticity;
    strain += other.strain;
    return *this;
  }
};

/// Evaluates the derivatives of stresslet() with respect to the target, per length of curve,
/// 1 / (length time).
///
/// With \f$ a = n\eta \f$ and \f$ b = 2n\cdot\eta \f$ the pressure is
/// \f$ \frac1\pi\mathrm{Re}\frac{a}{r^2} \f$, the vorticity \f$ -\frac1\pi\mathrm{Im}\frac{a}{r^2}
/// \f$, and the strain
/// \f$ -\frac{1}{2\pi}\left[\frac{b}{\bar r^2} + \frac{2r\bar a}{\bar r^3}\right] \f$.
inline FlowDerivatives stresslet_derivatives(Complex r, Complex n, Complex eta) {
  const Complex a = n * eta, inverse = 1.0 / r, conjugate = std::conj(inverse);
  const Complex curvature = std::numbers::inv_pi * a * inverse * inverse;
  return {
      curvature.real(), -curvature.imag(),
      -std::numbers::inv_pi * conjugate * conjugate * (dot(n, eta) + r * std::conj(a) * conjugate)};
}

/// Evaluates the derivatives of stokeslet() with respect to the target, 1 / time.
///
/// The pressure is \f$ \frac{1}{2\pi\mu}\mathrm{Re}\frac Fr \f$, the vorticity
/// \f$ -\frac{1}{2\pi\mu}\mathrm{Im}\frac Fr \f$, and the strain
/// \f$ -\frac{1}{4\pi\mu}\left[\frac{F}{\bar r} + \frac{r\bar F}{\bar r^2}\right] \f$.
inline FlowDerivatives stokeslet_derivatives(Complex r, Complex force, double mu) {
  const Complex inverse = 1.0 / r, conjugate = std::conj(inverse);
  const Complex strength = force / (4.0 * std::numbers::pi * mu);
  const Complex slope = 2.0 * strength * inverse;
  return {slope.real(), -slope.imag(),
          -conjugate * (strength + r * std::conj(strength) * conjugate)};
}

/// Evaluates the derivatives of rotlet() with respect to the target, 1 / time.
///
/// Pressure and vorticity are zero, and the strain is \f$ -\frac{iL}{2\pi\mu\bar r^2} \f$.
inline FlowDerivatives rotlet_derivatives(Complex r, double torque, double mu) {
  const Complex conjugate = std::conj(1.0 / r);
  return {0.0, 0.0, -imaginary * (torque / (2.0 * std::numbers::pi * mu)) * conjugate * conjugate};
}

}  // namespace stokesbook
