#pragma once

#include <cstddef>
#include <vector>

#include "stiv/contact_shape.hpp"
#include "stiv/rigid_path.hpp"

namespace stokesbook {

/// Records how a vertex of a component A comes near the polygon of a component B in a step.
struct VertexEvent {
  Eigen::Index vertex;  ///< vertex of A
  Eigen::Index edge;    ///< edge of B, closest to the vertex at this time
  double weight;        ///< w_s of (10.6): half the lengths of the two edges at the vertex
  double time;          ///< tau_I, from 0 to 1, at which gap, point and normal were taken: start of
                        ///< the contact if the vertex goes deep; otherwise 1, the end of the step
  double gap;           ///< g at the end of the step, length, < 0 if the vertex ends too deep
  Complex point;        ///< y, closest point of B's polygon, in B's frame, length
  Complex normal;       ///< n_I, unit, into the fluid about B, in B's frame
};

/// Counts the work of a search for contact.
struct SearchCost {
  std::size_t pairs = 0;     ///< pairs of components that passed the broad phase
  std::size_t vertices = 0;  ///< vertices whose paths were followed
  std::size_t queries = 0;   ///< queries of a polygon, for a closest point or a chord

  /// Adds the counts of another search.
  SearchCost& operator+=(const SearchCost& other) {
    pairs += other.pairs;
    vertices += other.vertices;
    queries += other.queries;
    return *this;
  }

  bool operator==(const SearchCost&) const = default;  ///< compares member by member
};

/// The distance that two components must keep, and options of the search.
struct Clearance {
  double separation;  ///< delta, length, > 0
  /// Tolerance of gaps, length, > 0: contact is found at most this much too early.
  double tolerance;
  double reach;  ///< vertices that end nearer to the other component are listed, length
  /// Part of the separation into which a vertex may intrude within a step, 0 to 1.
  double allowed_intrusion = 0.5;
};

/// The events of one component's vertices, and the work of finding them.
struct VertexEvents {
  std::vector<VertexEvent> events;  ///< ascending by vertex, at most one per vertex
  SearchCost cost;                  ///< cost of this search
};

/// Follows the vertices of a component A along their paths relative to a component B. This is one
/// half of the narrow phase: the vertices of B past A are the other half.
///
/// Let d be the signed distance from B's polygon and z(tau) the relative path (10.2). The first
/// contact is the time at which d has fallen to delta. The gap at the end of the step is measured
/// from the line through the touched point (10.5),
/// \f[ g = d(z_I) - \delta + n_I\cdot(z(1) - z_I), \f]
/// and remains negative however far beyond B the vertex ends. This gap is used for vertices that go
/// deep, that is, nearer than (1 - allowed_intrusion) delta. For all other vertices only the end of
/// the step counts, \f$ g = d(z(1)) - \delta \f$ with the normal there. The reason is sliding: a
/// vertex that slides along B at the distance delta, up to the tolerance, would end behind the
/// tilted line of every bend that it passes.
///
/// Runs of vertices whose bounding circle keeps away from B are left out. For most other vertices a
/// chord of the path proves that they never go deep. For the remaining vertices the search advances
/// in time by \f$ (d-\delta)/L \f$ (10.3) with a bound L of the speed (10.4): such a step cannot
/// skip a contact, however fast the vertex.
/// @param  path       of A, seen from B; the polygons do not overlap at its start
/// @return            events of vertices that end too deep, or end near B
/// @par Accuracy      first contact is found at a distance between delta and delta + tolerance,
///                    @ref claim_10_4; g has rounding error for B's polygon, which lies within its
///                    sag of the curve
/// @par Cost          a few queries of O(log M) per vertex that comes near; O(log M) for all others
/// @sa source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, Berkeley,
///             1996, for the advancement
VertexEvents vertex_events(const ContactShape& a, const ContactShape& b, const RelativePath& path,
                           const Clearance& clearance);

}  // namespace stokesbook
