#pragma once

#include "stiv/contacts.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// A volume by absolute velocities, and the forces that follow from it.
struct AbsoluteVolume {
  double volume;     ///< V, length^2, at most 0
  PairWrench force;  ///< derivative of V with respect to the displacements and rotations: force in
                     ///< length, torque in length^2
};

/// Computes the volume of a contact by the velocities that vertices have in the plane,
/// \f$ V = -\sum_s w_s(1-\tau_I)|u_s\cdot n_s| \f$ with each body's own outward normal, and its
/// derivative with frozen times, \f$ -\sum_s w_s(1-\tau_I)\,\mathrm{sign}(u_s\cdot n_s)\,n_s \f$.
///
/// This is for chapter 10 only, which shows what it does wrong: it depends on who observes, a body
/// at rest that is hit feels nothing, one that is overtaken is pulled into the other, and forces do
/// not add up to zero.
/// @param  pair       events of two components, found without a dip: all have a time
/// @param  tolerance  of gaps: events below its negative count, length
/// @return            volume and forces
/// @par Not for       contact: use connected_contacts()
/// @sa source: Bystricky, Shanbhag, Quaife, Int. J. Numer. Meth. Fluids 92 (2020)
AbsoluteVolume absolute_volume(const PairEvents& pair, double tolerance);

/// @}

}  // namespace stokesbook
