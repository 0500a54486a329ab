#pragma once

#include "stiv/contacts.hpp"

namespace stokesbook {

/// Holds a volume by absolute velocities, and the forces that are its derivative.
struct AbsoluteVolume {
  double volume;     ///< V, length^2, at most 0
  PairWrench force;  ///< derivative of V with respect to the displacements and rotations: force in
                     ///< length, torque in length^2
};

/// Computes the volume of a contact from the velocities of the vertices in the plane,
/// \f$ V = -\sum_s w_s(1-\tau_I)|u_s\cdot n_s| \f$ with each body's own outward normal, and its
/// derivative with frozen times, \f$ -\sum_s w_s(1-\tau_I)\,\mathrm{sign}(u_s\cdot n_s)\,n_s \f$
/// (10.11).
///
/// This function serves chapter 10 only, which shows its defects: volume and forces depend on the
/// observer, a body at rest that is hit feels no force, a body that is overtaken is pulled into the
/// other body, and the forces do not add up to zero.
/// @param  pair       events of two components, found with Clearance::allowed_intrusion = 0, so
///                    that each contact has the time when it began
/// @param  tolerance  length; events with a gap below its negative are summed
/// @par Not for       simulations with contact: use connected_contacts()
/// @sa source: Bystricky, Shanbhag, Quaife, Int. J. Numer. Meth. Fluids 92 (2020)
AbsoluteVolume absolute_volume(const PairEvents& pair, double tolerance);

}  // namespace stokesbook
