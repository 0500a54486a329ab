#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "lcp/contact_loop.hpp"
#include "near_singular/closest_points.hpp"
#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/contact/path_images.hpp"

namespace stokesbook {

/// Makes the polygons of components, whose distance from their curves is at most the sag.
/// Components of one shape and side share a polygon.
ContactShapes contact_shapes(const Discretisation& discretisation, double sag_limit);

/// Finds the paths of components that move with a velocity, packed by to_state(), for a time.
std::vector<RigidPath> straight_paths(const Configuration& start, const Eigen::VectorXd& velocity,
                                      double dt);

/// Returns whether forces can move two components apart: whether one of them is a free body.
bool is_movable_pair(const Discretisation& discretisation, std::size_t a, std::size_t b);

/// A stage of a step for which contact is to be resolved.
///
/// The mean velocity of the step is `known_velocity`, plus `share` times the velocity of the flow
/// and of contact at `acting`. Velocities are packed by to_state().
struct ContactStage {
  double t;          ///< time at which the forces act
  double dt;         ///< length of the step
  Placement start;   ///< placement at the beginning of the step
  Placement acting;  ///< placement in which forces act and the mobility is evaluated
  std::optional<Lattice> end_lattice;  ///< at the end of the step
  double share;                        ///< part of the step during which the forces act, 1 or 1/2
  Eigen::VectorXd known_velocity;      ///< from the stage before; zero in the first stage
  const CloserGaps& closer;            ///< pairs that may be closer than the separation
  int most_iterations;                 ///< largest number of linear complementarity problems
  Eigen::VectorXd free_velocity{};     ///< mean velocity of the step without contact in this stage
  Eigen::VectorXd guess{};             ///< velocity that contact adds at `acting`; empty: no guess
};

/// The point and the direction of a contact force.
struct UnitForce {
  Complex point;   ///< length
  Complex normal;  ///< unit vector, of the force on a
};

/// A vertex of one of the polygons of a pair.
struct PairVertex {
  bool of_b;            ///< whether the vertex belongs to b; else it belongs to a
  Eigen::Index vertex;  ///< number of the vertex
};

/// A constraint of a stage: the gap of two components must not be negative.
struct GapConstraint {
  ContactPair pair;                       ///< the components
  PairVertex nearest;                     ///< vertex near the closest points
  ContactRow row;                         ///< row of the polygons
  double gap = 0.0;                       ///< at the end of the step, minus the separation; length
  std::optional<ClosestPoints> points{};  ///< points of the curves there, if they measure the gap
  UnitForce force_on_a{};                 ///< by the curves
};

/// The separations of polygons and of curves.
struct ConstraintRules {
  double polygons;    ///< separation of polygons in general, with the sags of both, length
  double curves;      ///< separation of curves in general, length
  CloserGaps closer;  ///< separations of pairs that may be closer, of polygons and of curves
  double tolerance;   ///< tolerance of gaps, length

  /// Returns the separation of a pair, which is `everywhere` in general, length.
  double between(const ContactPair& pair, double everywhere) const;

  /// Finds the contacts of a step between the paths of images.
  Interferences find(const PathImages& images) const;
};

/// The gap functions of a stage and their Jacobian, as the contact loop of chapter 11 requires
/// them; remembers all constraints that it has returned.
///
/// The active pairs, which have constraints, are those that were violated at some velocity. Their
/// constraints are those that interferences() finds, those that they had at an earlier velocity,
/// and the closest point of their curves if that is nearer than all of these. A gap is that of the
/// curves at the end of the step. Forces act at the closest points of the acting configuration;
/// forces at the closest points of the end would lower the order of the method by one.
class GapConstraints {
 public:
  /// All arguments must outlive the constraints.
  GapConstraints(const ContactStage& stage, const Discretisation& discretisation,
                 const ContactShapes& shapes, const ConstraintRules& rules);

  /// Runs the contact loop with the exact Jacobian of the gaps, which converges fast; if that
  /// fails, with the Jacobian of the forces, whose linear problems are symmetric and have
  /// solutions.
  ///
  /// The step comes without its rows. The iterations of the result are those of both loops, at most
  /// those of the stage.
  ContactResult resolve(ContactStep step);

  /// Returns a constraint as the contact loop saw it last.
  const GapConstraint& at(const ContactKey& key) const { return constraints_.at(key); }

 private:
  ContactRows rows(const Eigen::VectorXd& velocity);
  std::vector<GapConstraint> active_constraints(const Eigen::VectorXd& velocity,
                                                const Placement& end);
  void find_missed_minimum(const GapConstraint& reported, const Placement& end);
  void add_earlier(std::vector<GapConstraint>& constraints, const Placement& end) const;
  void measure(GapConstraint& constraint, const Placement& end) const;
  bool is_violated(const std::vector<GapConstraint>& constraints) const;
  double polygon_error(const GapConstraint& constraint) const;
  ClosestPoints closest(const GapConstraint& constraint, const Placement& at) const;
  SmoothCurve curve(std::size_t component, const Pose& pose) const;

  const ContactStage& stage_;
  const Discretisation& discretisation_;
  const ContactShapes& shapes_;
  const ConstraintRules& rules_;
  std::set<ContactPair> active_;                             // pairs violated at some velocity
  std::map<ContactPair, std::vector<PairVertex>> vertices_;  // of the pairs' constraints so far
  std::map<ContactKey, GapConstraint> constraints_;          // returned so far
};

}  // namespace stokesbook
