#pragma once

#include <compare>
#include <cstddef>

#include "stiv/rigid_path.hpp"
#include "stiv/vertex_events.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// A force and a torque about the component's centre, per unit of a multiplier; or the derivative
/// of a length with respect to centre and orientation.
struct Wrench {
  Complex force;        ///< dimensionless
  double torque = 0.0;  ///< length
};

/// What a row of the constraints is for the two components of its contact; for all others it is 0.
struct PairWrench {
  Wrench on_a;  ///< on the component a
  Wrench on_b;  ///< on the component b
};

/// Names a row from one iteration to the next.
struct RowKey {
  std::size_t vertex_of = 0;   ///< component whose polygon's vertex it is
  std::size_t polygon_of = 0;  ///< component whose polygon the vertex comes near to
  Eigen::Index vertex = 0;     ///< number of the vertex

  /// Compares member by member.
  /// @return order of the keys
  auto operator<=>(const RowKey&) const = default;
};

/// One scalar constraint \f$ g \ge 0 \f$ between two components.
///
/// Both wrenches balance: their forces are opposite, and so are their torques about one point, as g
/// does not change when both components move together. They do it about the centres of different
/// times.
struct ContactRow {
  RowKey key;             ///< of the deepest vertex where the row stands for several
  double gap;             ///< g at the end of the step, length
  double time;            ///< when gap and normal were taken: see VertexEvent::time
  Complex point;          ///< where the contact force acts, in the plane, length
  Complex normal;         ///< of the force on a, in the plane, unit
  PairWrench force;       ///< for forces: balanced about the centres at the start of the step
  PairWrench derivative;  ///< of g with respect to the poses at the end, about the centres there
};

/// The paths of the two components of a contact.
struct PathPair {
  std::size_t a;     ///< number of the one, less than b
  std::size_t b;     ///< number of the other
  RigidPath path_a;  ///< of a
  RigidPath path_b;  ///< of b
};

/// Makes the row of a vertex event.
///
/// With the world normal n = R(theta_B) n_I, the derivative has the arms of the vertex at the end,
/// \f$ (n, a_A\times n) \f$ for the vertex's component and \f$ (-n, -a_B\times n) \f$ for the
/// polygon's. The force has the orientations when the event was measured, the centres at the start,
/// where the Stokes equations are solved, and arms to the mean of the vertex
/// and the point it touches.
/// @param  event      of a vertex
/// @param  vertex     of its component's polygon, in its own frame, length
/// @param  of_a       true where the vertex is one of a's
/// @param  paths      of both components
/// @return            row with gap and wrenches
/// @par Accuracy      the derivative is exact for the closest edge of the polygon,
/// @ref claim_10_10; forces balance to rounding, @ref claim_10_11
ContactRow contact_row(const VertexEvent& event, Complex vertex, bool of_a, const PathPair& paths);

/// @}

}  // namespace stokesbook
