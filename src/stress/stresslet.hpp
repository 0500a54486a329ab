#pragma once

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Computes the stresslet of a component from its density, \f$ S_{11} + iS_{12} =
/// -\mu\oint n\eta\,ds \f$ (complex product; \f$ S_{22} = -S_{11} \f$), by (07.14).
///
/// The stresslet is the symmetric dipole of the forces that the fluid exerts on the component, with
/// Batchelor's sign. For a rigid body the stresslet is the traceless symmetric part of
/// \f$ \oint (\sigma\nu)\otimes(x-c)\,ds \f$ with \f$ \nu = -n \f$ into the fluid. The rigid part
/// of the density, the Stokeslet and the rotlet contribute nothing.
/// @param  density  at the nodes, length / time
/// @return          S_11 + i S_12, force length per unit of depth
/// @par Accuracy    that of the rule: geometric in N, @ref claim_07_23
/// @par Not for     components with a force, whose dipole depends on the point c
/// @sa source: Batchelor, J. Fluid Mech. 41 (1970), 545
inline Complex body_stresslet(const Curve& curve, const ComplexVector& density, double mu) {
  const ComplexVector weighted_normal = normals(curve).cwiseProduct(weights(curve));
  return -mu * weighted_normal.cwiseProduct(density).sum();
}

/// Computes the intrinsic viscosity of bodies in a linear flow: the relative increase of the
/// viscosity that the bodies cause, divided by their area fraction \f$ \phi \f$ (07.17),
/// \f[ [\mu] = \frac{S:E}{2\mu\,E:E\,A_b} = \frac{\mathrm{Re}(\bar q S)}{\mu|q|^2A_b},\qquad
///     \mu_\mathrm{eff} = \mu(1 + \phi[\mu]). \f]
///
/// The mean stress of a suspension is \f$ -pI + 2\mu E + \sum_kS_k/A \f$ (07.16). Free circles far
/// from each other have \f$ S = 4\pi\mu a^2E \f$, hence \f$ [\mu] = 2 \f$. Free ellipses have the
/// same \f$ [\mu] \f$ in the mean over a Jeffery orbit, @ref claim_07_29.
/// @param  stresslet  sum of the bodies' stresslets, S_11 + i S_12, force length
/// @param  strain     q = E_11 - E_22 + 2i E_12 of the linear flow, 1 / time, not zero
/// @param  area       A_b, total area of the bodies, length^2
inline double intrinsic_viscosity(Complex stresslet, Complex strain, double area, double mu) {
  return dot(strain, stresslet) / (mu * std::norm(strain) * area);
}

}  // namespace stokesbook
