#pragma once

#include <vector>

#include "stiv/contacts.hpp"
#include "stiv/near_pairs.hpp"
#include "stiv/separation.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// What components are to keep.
struct ContactRules {
  Separation separation;                ///< of the polygons
  double tolerance;                     ///< of gaps, length, > 0; such as 1e-3 of the separation
  RowChoice rows = RowChoice::deepest;  ///< which rows stand for a violated contact
  double dip = 0.5;  ///< part of the separation that may be lost within a step, see vertex_events()
};

/// The contacts of a step.
struct Interferences {
  std::vector<Contact> contacts;  ///< ascending by pair
  SearchCost cost;                ///< what finding them took

  /// Tells whether the step may be taken as it is.
  /// @return true when no contact is violated
  bool admits_step() const;
};

/// Finds the contacts that a step makes, or comes near to: the space-time interference of all pairs
/// of components, by their relative motion.
///
/// A contact is violated where vertices end nearer than the separation, or have passed through; how
/// far is its volume \f$ V = \sum_s w_s\min(g_s, 0) \f$. Contacts that end within four separations
/// have rows too, so that those that carry a load do not drop out between iterations.
/// @param  shapes  of n components: bodies, held or not, inner walls, and enclosing ones
/// @param  paths   of the same, in the step; at its start no polygons overlap, see polygon_gaps()
/// @param  rules   separation, tolerance and rows
/// @return         contacts, the same bits for any number of threads
/// @throws std::invalid_argument when numbers of shapes and paths differ, a path is not finite, or
///                 separation or tolerance is not positive
/// @par Accuracy   of gaps: rounding for polygons, @ref claim_10_1; the sum of two sags for curves,
/// @ref claim_10_2
/// @par Cost       O(n log n) and a few queries for each vertex that comes near another component
Interferences interferences(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                            const ContactRules& rules);

/// @}

}  // namespace stokesbook
