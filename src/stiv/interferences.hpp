#pragma once

#include <algorithm>
#include <vector>

#include "stiv/contacts.hpp"
#include "stiv/near_pairs.hpp"

namespace stokesbook {

/// Distances that components must keep, and options of the search for contacts.
struct ContactRules {
  Separation separation;  ///< separation of the polygons
  double tolerance;       ///< tolerance of gaps, length, > 0; e.g. 1e-3 of the separation
  RowChoice rows = RowChoice::deepest;  ///< rows that violated contacts have
  double allowed_intrusion = 0.5;       ///< see Clearance, 0 to 1
};

/// Contacts that end within this many separations are listed even if no gap is violated.
inline constexpr double listed_separations = 4.0;

/// The contacts of a step.
struct Interferences {
  std::vector<Contact> contacts;  ///< ascending by pair
  SearchCost cost;                ///< cost of the search

  /// Returns whether no contact is violated, so that the step may be taken unchanged.
  bool admits_step() const { return std::ranges::none_of(contacts, &Contact::is_violated); }
};

/// Finds the contacts of a step, violated ones and near ones: the space-time interference of all
/// pairs of components, from their relative motion.
///
/// A contact is violated if vertices end nearer than the separation, or have passed through the
/// other component; the volume \f$ V = \sum_s w_s\min(g_s, 0) \f$ measures the violation (10.6).
/// Contacts that end within four separations have rows too, so that contacts that carry a load do
/// not drop out between iterations.
/// The result does not depend on the number of threads.
/// @param  paths   of the components; at the start no polygons overlap, see polygon_gaps()
/// @throws std::invalid_argument when numbers of shapes and paths differ, a path is not finite, or
///                 a rule is out of its range
/// @par Accuracy   of gaps: rounding for polygons, @ref claim_10_1; the sum of two sags for curves,
///                 @ref claim_10_2
/// @par Cost       O(n log n), and a few queries for each vertex that comes near another component
Interferences interferences(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                            const ContactRules& rules);

}  // namespace stokesbook
