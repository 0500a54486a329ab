#pragma once

#include <cstddef>
#include <vector>

#include "stiv/contact_row.hpp"
#include "stiv/vertex_events.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// Which rows stand for a contact. All choices have the same set of admissible poses.
enum class RowChoice {
  deepest,    ///< deepest vertex, other local minima of the gap, ends of flat contacts
  aggregate,  ///< the volume divided by the length that it is over, as published
  every       ///< one for every vertex that ends too deep
};

/// A connected contact of two components.
struct Contact {
  std::size_t a;                 ///< one component
  std::size_t b;                 ///< the other one, a < b
  double volume;                 ///< sum of w min(g, 0) over its violations, length^2; 0 if none
  std::vector<ContactRow> rows;  ///< ascending by key, at least one

  /// Tells whether the step must not be taken as it is.
  /// @return true when a vertex ends too deep by more than the tolerance
  bool is_violated() const { return volume < 0.0; }
};

/// The vertex events of two components, both ways.
struct PairEvents {
  PathPair paths;                     ///< numbers and paths of both
  const ContactShape& shape_a;        ///< of a
  const ContactShape& shape_b;        ///< of b
  std::vector<VertexEvent> events_a;  ///< of a's vertices against b's polygon, ascending by vertex
  std::vector<VertexEvent> events_b;  ///< of b's vertices against a's polygon, ascending by vertex
  SearchCost cost;                    ///< of both searches
};

/// Follows the vertices of either component past the other: the narrow phase.
///
/// Polygons that come together do so first at a vertex of one of them: no edges need be compared
/// with edges.
/// @param  shapes     of all components, which outlive the events
/// @param  paths      of two of them, as for vertex_events()
/// @param  clearance  separation, tolerance and watch
/// @return            events both ways
PairEvents pair_events(const ContactShapes& shapes, const PathPair& paths,
                       const Clearance& clearance);

/// Groups the events of a pair into connected contacts: violations, and what ends near without any.
///
/// Runs of consecutive vertices belong together, and so do runs of either polygon where an edge
/// that one comes near to is within two vertices of the other. Rows are at local minima of the gap,
/// between which it rises by more than the two sags: less is the polygons', not the curves'. A
/// minimum along which more than four vertices are that near is a flat contact, and has rows at
/// both ends too.
/// @param  pair       its events
/// @param  tolerance  of gaps: events below its negative are violations, length
/// @param  rows       which rows to return
/// @return            violations, then near contacts, in an order that only the events decide
/// @par Cost          O(e log e) for e events
std::vector<Contact> connected_contacts(const PairEvents& pair, double tolerance, RowChoice rows);

/// @}

}  // namespace stokesbook
