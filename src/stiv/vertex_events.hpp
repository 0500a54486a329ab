#pragma once

#include <cstddef>
#include <vector>

#include "stiv/contact_shape.hpp"
#include "stiv/rigid_path.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// What a vertex of one component A does to the polygon of another one B in a step.
struct VertexEvent {
  Eigen::Index vertex;  ///< of A
  Eigen::Index edge;    ///< of B, that it comes closest to
  double weight;        ///< length of A's polygon that the vertex stands for
  double time;          ///< when gap, point and normal were taken: tau_I, from 0 to 1, where the
                        ///< contact began that the vertex goes deep in; 1, the end, without one
  double gap;           ///< g, length, < 0 where the vertex ends too deep
  Complex point;        ///< y, closest of B's polygon, in B's frame, length
  Complex normal;       ///< n, into the fluid about B, in B's frame
};

/// How much a search for contact took.
struct SearchCost {
  std::size_t pairs = 0;     ///< pairs of components that the broad phase left
  std::size_t vertices = 0;  ///< vertices whose paths were followed
  std::size_t queries = 0;   ///< of closest points and of chords

  /// Adds another search.
  /// @param  other  what that took
  /// @return        the sum
  SearchCost& operator+=(const SearchCost& other) {
    pairs += other.pairs;
    vertices += other.vertices;
    queries += other.queries;
    return *this;
  }

  /// @return true when all members are equal
  bool operator==(const SearchCost&) const = default;
};

/// What two components are to keep, and how closely the search looks.
struct Clearance {
  double separation;  ///< delta, length, > 0
  double tolerance;   ///< of gaps, length, > 0: contact is found up to this early
  double watch;       ///< distance at the end of the step up to which vertices are listed, length
  double dip = 0.5;   ///< part of the separation that a vertex may lose within a step, 0 to 1
};

/// The events of one component's vertices, and what finding them took.
struct VertexEvents {
  std::vector<VertexEvent> events;  ///< ascending by vertex, one a vertex at most
  SearchCost cost;                  ///< of this search
};

/// Follows the vertices of a component A along their paths relative to a component B: the narrow
/// phase, one way.
///
/// With the signed distance d of B's polygon and the relative path z(tau), the first contact is
/// where d comes down to delta, and the gap that it leaves at the end is that to the line through
/// the touched point,
/// \f[ g = d(z_I) - \delta + n_I\cdot(z(1) - z_I), \f]
/// however far beyond B the vertex ends. This holds for vertices that go deep, nearer than
/// (1 - dip) delta. For all others the end alone counts, \f$ g = d(z(1)) - \delta \f$ with the
/// normal there: what slides along B at a distance of delta, up to the tolerance, would meet tilted
/// lines at every bend that it passes.
///
/// Runs of vertices whose bounding circle stays away are not looked at one by one. Of most of the
/// others a chord of the path shows that they go nowhere deep. For the rest the search advances by
/// \f$ (d-\delta)/L \f$, with a bound L of the speed: that cannot skip a contact, however fast.
/// Where this creeps, as along a wall, it tries chords that grow until one comes too near. In
/// contact it goes on in steps of half the separation, which cannot pass through B either.
/// @param  a          shape of A
/// @param  b          shape of B
/// @param  path       of A, seen from B; the polygons do not overlap at its start
/// @param  clearance  separation, tolerance, watch and dip
/// @return            vertices that end too deep, and those that end near B
/// @par Accuracy      contact is found at delta + tolerance at the latest, @ref claim_10_4; g has
/// rounding error for B's polygon, which lies within its sag of the curve
/// @par Cost          a few queries O(log M) a vertex that comes near; O(log M) for all others
/// @sa source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, Berkeley,
/// 1996, for the advancement
VertexEvents vertex_events(const ContactShape& a, const ContactShape& b, const RelativePath& path,
                           const Clearance& clearance);

/// @}

}  // namespace stokesbook
