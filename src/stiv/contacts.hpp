#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "stiv/rigid_path.hpp"
#include "stiv/vertex_events.hpp"

namespace stokesbook {

/// A force and a torque about the component's centre, per unit of a multiplier, or the derivative
/// of a length with respect to centre and orientation.
struct Wrench {
  Complex force;        ///< dimensionless
  double torque = 0.0;  ///< length
};

/// Holds the entries of a row for the two components of its contact. The row is zero for all other
/// components.
struct PairWrench {
  Wrench on_a;  ///< on the component a
  Wrench on_b;  ///< on the component b
};

/// Identifies a row from one iteration to the next.
struct RowKey {
  std::size_t vertex_of = 0;   ///< component to whose polygon the vertex belongs
  std::size_t polygon_of = 0;  ///< component whose polygon the vertex approaches
  Eigen::Index vertex = 0;     ///< number of the vertex

  auto operator<=>(const RowKey&) const = default;  ///< compares member by member
};

/// One scalar constraint \f$ g \ge 0 \f$ between two components.
///
/// The wrenches on a and b balance: their forces are opposite, and so are their torques about any
/// common point, because g does not change when both components move together. `force` balances
/// with the centres at the start of the step, `derivative` with the centres at its end
/// (10.10).
struct ContactRow {
  RowKey key;        ///< key of the vertex, or of the deepest one if the row is a mean
  double gap;        ///< g at the end of the step, length
  double time;       ///< at which gap and normal were taken: see VertexEvent::time
  Complex point;     ///< at which the contact force acts, in the plane, length
  Complex normal;    ///< normal of the force on a, in the plane, unit
  PairWrench force;  ///< force of a unit multiplier, about the centres at the start of the step
  PairWrench derivative;  ///< derivative of g by the poses at the end of the step (10.9)
};

/// The paths of the two components of a contact.
struct PathPair {
  std::size_t a;     ///< number of one component, less than b
  std::size_t b;     ///< number of the other component
  RigidPath path_a;  ///< path of a
  RigidPath path_b;  ///< path of b
};

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

  /// Returns whether a vertex ends too deep by more than the tolerance.
  bool is_violated() const { return volume < 0.0; }
};

/// The vertex events of two components: vertices of each against the polygon of the other.
struct PairEvents {
  PathPair paths;                     ///< numbers and paths of both
  const ContactShape& shape_a;        ///< shape of a
  const ContactShape& shape_b;        ///< shape of b
  std::vector<VertexEvent> events_a;  ///< a's vertices against b's polygon, ascending by vertex
  std::vector<VertexEvent> events_b;  ///< b's vertices against a's polygon, ascending by vertex
  SearchCost cost;                    ///< cost of both searches
};

/// Follows the vertices of each of two components past the other: the narrow phase.
///
/// Polygons that approach each other touch first at a vertex of one of them, so edges need not be
/// compared with edges.
/// @param  shapes     of all components, which must outlive the events
/// @param  paths      of two components, which do not overlap at the start of the step
PairEvents pair_events(const ContactShapes& shapes, const PathPair& paths,
                       const Clearance& clearance);

/// Makes the row of a vertex event.
///
/// With the normal n = R(theta_B) n_I in the plane, the derivative is \f$ (n, r_A\times n) \f$ for
/// the vertex's component and \f$ (-n, -r_B\times n) \f$ for the polygon's component (10.9), with
/// the arms of the vertex at the end of the step. The force has the same form, with the
/// orientations at VertexEvent::time, the centres at the start of the step, where the Stokes
/// equations are solved, and the arms to the point half-way between the vertex and the point that
/// it touches.
/// @param  vertex     place of the vertex in its component's frame, length
/// @par Accuracy      the derivative is exact for the closest edge of the polygon,
///                    @ref claim_10_10; forces balance to rounding, @ref claim_10_11
ContactRow contact_row(const VertexEvent& event, Complex vertex, bool of_a, const PathPair& paths);

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
