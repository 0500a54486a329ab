#pragma once

#include <string>
#include <vector>

#include "record/run_data.hpp"
#include "stiv/polygon_gaps.hpp"
#include "suspension/contact/contact_mobility.hpp"
#include "suspension/contact/gap_constraints.hpp"

namespace stokesbook {

/// The net force and torque of the forces that components exert on each other.
struct Imbalance {
  double force,  ///< net force over the largest force
      torque;    ///< net torque over the largest force times its longest lever
};

/// Measures how well forces between components balance, independently of the origin; zero if there
/// are no forces.
///
/// Torques are taken about the mean position of the loaded components. The lever is the largest
/// distance of a loaded component from there plus the largest radius. The largest force is that on
/// a component, or the torque on a component over its radius.
/// @param  force   3K numbers: force and torque about its position of each of K components
/// @param  acting  configuration in which they act
/// @param  torque  net torque of forces that balance: the sum of w x F over the forces F that
///                 images exert, each moved by its lattice vector w
Imbalance imbalance(const Eigen::VectorXd& force, const Configuration& acting,
                    const ContactShapes& shapes, double torque = 0.0);

/// The contact of a stage.
struct ContactOutcome {
  ContactResult result;              ///< mean velocity, multipliers, and the end of the loop
  std::vector<ContactForce> forces;  ///< forces of all constraints with a force
  Imbalance imbalance{0.0, 0.0};     ///< imbalance of the forces of all pairs
  double kkt_residual = 0.0;         ///< KKT residual of the result, over the separation
  int iterations = 0;                ///< linear problems, including those with inaccurate columns
  double correction = 0.0;           ///< ContactMobility::relative_correction() of resolved forces
  /// Pairs whose nodes do not resolve the contact forces: their own force does not open the gap, or
  /// the linear problem has no solution, or the mobility was corrected by more than the solver's
  /// tolerance.
  std::vector<ComponentPair> unresolved{};

  /// Returns whether the velocity of the result keeps all gaps open.
  bool is_resolved() const { return result.status == ContactStatus::resolved; }
};

/// Keeps the components of a scene at their minimum separation.
///
/// Contact is predicted by interferences() of the polygons of all components, whose distance from
/// the curves is at most 0.004 separations, and resolved by resolve_contact() with the mobility of
/// the whole suspension and the gaps of the curves. A gap with a force is one separation wide to a
/// part in 1e5, or up to 1.016 separations if polygons and curves disagree on which points are the
/// closest. No state with too_close() pairs is accepted.
///
/// In a periodic cell, a component also keeps apart from the images of others and from its own.
/// path_images() adds their paths, so that chapters 10 and 11 know no lattice.
class SuspensionContact {
 public:
  /// Prepares the polygons of a scene with [contact]. The solver must outlive this.
  explicit SuspensionContact(const SuspensionSolver& solver);

  /// Finds the pairs that start with a gap of at most the separation, and their gaps.
  ///
  /// @throws ConfigurationError when components overlap, with all pairs and depths; and when gaps
  ///                are narrower than the separation, unless contact.allow_close is true
  CloserGaps admit_start(const Placement& start) const;

  /// Updates the gaps of pairs that started closer than the separation, and leaves out pairs that
  /// are no longer closer: gaps that have opened must not close again.
  CloserGaps update_closer(const CloserGaps& closer, const Placement& placement) const;

  /// Resolves the contact of a stage, with the mobility of the configuration in which forces act.
  /// The resulting velocity is valid only if the contact is resolved.
  ///
  /// @throws SolverError as ContactMobility does
  ContactOutcome resolve(const ContactStage& stage, ContactMobility& mobility) const;

  /// Measures how far a step moves components past each other that come near each other: the
  /// largest path of a point of one component in the frame of the other, over the smaller ratio of
  /// area and perimeter, which is half the radius for a disk. The velocity is packed by to_rate().
  double relative_displacement(const Placement& start, const Eigen::VectorXd& velocity, double dt,
                               const std::optional<Lattice>& end_lattice) const;

  /// Lists the pairs that violate the separation by more than 2e-5 separations, with the gaps of
  /// their curves, as text; empty if there is none. Pairs of `closer` may be closer.
  std::string too_close(const Placement& placement, const CloserGaps& closer) const;

 private:
  std::vector<std::pair<ContactPair, double>> gaps(const Placement& placement) const;
  ConstraintRules constraint_rules(const CloserGaps& closer) const;

  const SuspensionSolver& solver_;
  double separation_;
  double polygon_separation_;  // with the sags of both
  ContactShapes shapes_;
};

}  // namespace stokesbook
