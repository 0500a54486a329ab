#pragma once

#include <cstddef>
#include <vector>

#include "stiv/contact_row.hpp"
#include "stiv/vertex_events.hpp"

namespace stokesbook {

/// Selects the rows that a contact has. All choices admit the same poses.
enum class RowChoice {
  deepest,    ///< rows of the deepest vertex, other local minima of the gap, ends of flat contacts
  aggregate,  ///< one row: the volume, as in the published method, divided by the contact's length
  every       ///< one row for every vertex that ends too deep
};

/// A connected contact of two components.
struct Contact {
  std::size_t a;                 ///< one component
  std::size_t b;                 ///< the other component, a < b
  double volume;                 ///< V of (10.6), length^2, at most 0; 0 if not violated
  std::vector<ContactRow> rows;  ///< ascending by key, at least one

  /// Returns whether a vertex ends too deep by more than the tolerance, so that the step must not
  /// be taken unchanged.
  bool is_violated() const { return volume < 0.0; }
};

/// The vertex events of two components: vertices of each against the polygon of the other.
struct PairEvents {
  PathPair paths;                     ///< numbers and paths of both
  const ContactShape& shape_a;        ///< of a
  const ContactShape& shape_b;        ///< of b
  std::vector<VertexEvent> events_a;  ///< of a's vertices against b's polygon, ascending by vertex
  std::vector<VertexEvent> events_b;  ///< of b's vertices against a's polygon, ascending by vertex
  SearchCost cost;                    ///< of both searches
};

/// Follows the vertices of each of two components past the other: the narrow phase.
///
/// Polygons that approach each other touch first at a vertex of one of them, so edges need not be
/// compared with edges.
/// @param  shapes     of all components, which must outlive the events
/// @param  paths      of two components, which do not overlap at the start of the step
PairEvents pair_events(const ContactShapes& shapes, const PathPair& paths,
                       const Clearance& clearance);

/// Groups the events of a pair into connected contacts, violated ones and near ones.
///
/// Consecutive vertices with events form a run. A run of one polygon and a run of the other belong
/// to the same contact if a vertex of one run is closest to an edge that has a vertex of the other
/// run, or is within two vertices of it.
///
/// Rows are at local minima of the gap along a run. Between two minima the gap must rise by more
/// than the sum of the two sags, because smaller variations are due to the polygons and not to the
/// curves. If the gaps of more than four consecutive vertices, the minimum included, exceed the
/// minimum by at most this sum, the contact is flat there, and has rows at both ends of this
/// stretch as well.
/// @param  tolerance  length; events with a gap below its negative are violations
/// @return            violations, then near contacts, in an order that depends only on the events
/// @par Cost          O(e log e) for e events
std::vector<Contact> connected_contacts(const PairEvents& pair, double tolerance, RowChoice rows);

}  // namespace stokesbook
