#pragma once

#include <cmath>

#include "double_layer/flow_derivatives.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup stress
/// @{

/// A symmetric tensor of the plane.
struct Stress {
  double s11 = 0.0,  ///< force / length^2, as the others
      s12 = 0.0,     ///< shear stress
      s22 = 0.0;     ///< on surfaces across direction 2
};

/// Derivatives of the velocity.
struct VelocityGradient {
  double du1_dx1 = 0.0,  ///< 1 / time, as the others
      du1_dx2 = 0.0,     ///< of the first component along direction 2
      du2_dx1 = 0.0,     ///< of the second component along direction 1
      du2_dx2 = 0.0;     ///< \f$ -\partial_1 u_1 \f$
};

/// Computes the stress \f$ \sigma = -pI + 2\mu e \f$.
///
/// @param  flow  derivatives at a point
/// @param  mu    viscosity, force time / length^2
/// @return       force / length^2
inline Stress stress(const FlowDerivatives& flow, double mu) {
  return {mu * (flow.strain.real() - flow.pressure), mu * flow.strain.imag(),
          mu * (-flow.strain.real() - flow.pressure)};
}

/// Computes the traction on a surface, \f$ \sigma n = \mu(-\frac p\mu n + q\bar n) \f$: in complex
/// notation \f$ 2e\,n = q\bar n \f$ with \f$ q = e_{11} - e_{22} + 2ie_{12} \f$.
///
/// @param  flow  derivatives at a point
/// @param  n     unit normal; the traction is that of the material towards which it points
/// @param  mu    viscosity, force time / length^2
/// @return       force / length^2
inline Complex traction(const FlowDerivatives& flow, Complex n, double mu) {
  return mu * (flow.strain * std::conj(n) - flow.pressure * n);
}

/// Computes the velocity gradient, \f$ \partial_j u_i = e_{ij} + \frac\omega2\,\epsilon_{ji} \f$.
///
/// @param  flow  derivatives at a point
/// @return       1 / time, without trace
inline VelocityGradient velocity_gradient(const FlowDerivatives& flow) {
  const double stretch = 0.5 * flow.strain.real(), shear = flow.strain.imag();
  return {stretch, 0.5 * (shear - flow.vorticity), 0.5 * (shear + flow.vorticity), -stretch};
}

/// Reads the derivatives of a linear flow, or of any at a point, from its velocity gradient, with
/// pressure zero: inverse of velocity_gradient().
///
/// @param  gradient  1 / time; du2_dx2 is taken to be -du1_dx1
/// @return           pressure zero, vorticity and strain
inline FlowDerivatives flow_derivatives(const VelocityGradient& gradient) {
  return {0.0,
          gradient.du2_dx1 - gradient.du1_dx2,
          {2.0 * gradient.du1_dx1, gradient.du1_dx2 + gradient.du2_dx1}};
}

/// Computes the energy that turns to heat, \f$ 2\mu\, e:e = \mu|q|^2 \f$.
///
/// @param  flow  derivatives at a point
/// @param  mu    viscosity, force time / length^2
/// @return       per area and time, force / (length time)
inline double dissipation_density(const FlowDerivatives& flow, double mu) {
  return mu * std::norm(flow.strain);
}

/// Computes the largest shear stress over all directions, half the difference of the principal
/// stresses: \f$ \mu|q| \f$.
///
/// @param  flow  derivatives at a point
/// @param  mu    viscosity, force time / length^2
/// @return       force / length^2, >= 0
inline double largest_shear_stress(const FlowDerivatives& flow, double mu) {
  return mu * std::abs(flow.strain);
}

/// @}

}  // namespace stokesbook
