#pragma once

#include <cmath>

#include "double_layer/flow_derivatives.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A symmetric tensor of the plane.
struct Stress {
  double s11 = 0.0,  ///< normal stress in direction 1, force / length^2
      s12 = 0.0,     ///< shear stress, force / length^2
      s22 = 0.0;     ///< normal stress in direction 2, force / length^2
};

/// Derivatives of the velocity.
struct VelocityGradient {
  double du1_dx1 = 0.0,  ///< \f$ \partial_1 u_1 \f$, 1 / time
      du1_dx2 = 0.0,     ///< \f$ \partial_2 u_1 \f$, 1 / time
      du2_dx1 = 0.0,     ///< \f$ \partial_1 u_2 \f$, 1 / time
      du2_dx2 = 0.0;     ///< \f$ \partial_2 u_2 = -\partial_1 u_1 \f$, 1 / time
};

/// Computes the stress \f$ \sigma = -pI + 2\mu e \f$ (07.1), with the viscosity mu.
inline Stress stress(const FlowDerivatives& flow, double mu) {
  return {mu * (flow.strain.real() - flow.pressure), mu * flow.strain.imag(),
          mu * (-flow.strain.real() - flow.pressure)};
}

/// Computes the traction on a surface, \f$ \sigma n = \mu(-\frac p\mu n + q\bar n) \f$ (07.5): in
/// complex notation \f$ 2e\,n = q\bar n \f$ with \f$ q = e_{11} - e_{22} + 2ie_{12} \f$.
///
/// @param  n  unit normal; the material on the side to which n points exerts the traction
/// @return    force / length^2
inline Complex traction(const FlowDerivatives& flow, Complex n, double mu) {
  return mu * (flow.strain * std::conj(n) - flow.pressure * n);
}

/// Computes the velocity gradient, \f$ \partial_j u_i = e_{ij} + \frac\omega2\,\epsilon_{ji} \f$
/// (07.5), with trace zero.
inline VelocityGradient velocity_gradient(const FlowDerivatives& flow) {
  const double stretch = 0.5 * flow.strain.real(), shear = flow.strain.imag();
  return {stretch, 0.5 * (shear - flow.vorticity), 0.5 * (shear + flow.vorticity), -stretch};
}

/// Computes vorticity and strain from the velocity gradient of a linear flow, or of any flow at a
/// point, and sets the pressure to zero: inverse of velocity_gradient(). The member du2_dx2 is
/// taken to be -du1_dx1.
inline FlowDerivatives flow_derivatives(const VelocityGradient& gradient) {
  return {0.0,
          gradient.du2_dx1 - gradient.du1_dx2,
          {2.0 * gradient.du1_dx1, gradient.du1_dx2 + gradient.du2_dx1}};
}

/// Computes the energy that is dissipated per area and time, \f$ 2\mu\, e:e = \mu|q|^2 \f$ (07.5),
/// force / (length time).
inline double dissipation_density(const FlowDerivatives& flow, double mu) {
  return mu * std::norm(flow.strain);
}

/// Computes the largest shear stress over all directions, half the difference of the principal
/// stresses: \f$ \mu|q| \ge 0 \f$.
inline double largest_shear_stress(const FlowDerivatives& flow, double mu) {
  return mu * std::abs(flow.strain);
}

}  // namespace stokesbook
