#pragma once

#include <string>
#include <vector>

#include "lcp/contact_loop.hpp"
#include "record/run_data.hpp"
#include "stiv/interferences.hpp"
#include "stiv/polygon_gaps.hpp"
#include "suspension/contact/contact_mobility.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Packs pairs into numbers.
///
/// @param  pairs  P of them
/// @return        3P numbers: both components, and the gap
Eigen::VectorXd to_numbers(const CloserPairs& pairs);

/// Unpacks pairs.
///
/// @param  numbers  as to_numbers() packs them
/// @return          pairs
CloserPairs to_pairs(const Eigen::VectorXd& numbers);

/// Makes the polygons of components. Those of one shape and side share theirs.
///
/// @param  discretisation  of all components
/// @param  sag_limit       largest distance of a polygon from its curve, length
/// @return                 one a component
ContactShapes contact_shapes(const Discretisation& discretisation, double sag_limit);

/// What forces that components exert on each other leave over.
struct Imbalance {
  double force,  ///< net force over the largest
      torque;    ///< net torque over the largest force and the lever that it may have
};

/// Measures how well forces between components balance, wherever the origin is.
///
/// Torques are taken about the mean position of the components that bear a load; the lever is the
/// largest distance of these from there and the largest of their radii, added. The largest force
/// is that on a component, or a component's torque over its radius.
/// @param  force   3K numbers: force and torque about its position of each of K components
/// @param  acting  where they act
/// @param  shapes  of the components
/// @return         rounding for forces that balance; zero where there are none
Imbalance imbalance(const Eigen::VectorXd& force, const Configuration& acting,
                    const ContactShapes& shapes);

/// A step, or a stage of one, for which contact is to be resolved.
struct ContactStage {
  const Configuration& start;  ///< where the step begins
  Eigen::VectorXd
      free_velocity;  ///< mean velocity of the step without contact, as to_rate() packs it
  double dt;          ///< length of the step
  const Configuration& acting;  ///< where forces act, and the response is taken
  double share;                 ///< of the step for which they act, 1 or 1/2
  /// What contact added to velocities where forces acted before, as to_rate() packs them; empty at
  /// first.
  const Eigen::VectorXd& added;
  int most_iterations;  ///< linear problems after which contact is not resolved
};

/// What contact made of a step.
struct ContactOutcome {
  ContactResult result;              ///< mean velocity, multipliers, and how the loop ended
  std::vector<ContactForce> forces;  ///< of all rows that carry one
  double force_imbalance = 0.0;      ///< net force of all pairs over the largest force
  double torque_imbalance = 0.0;     ///< net torque, both by imbalance()
  double kkt_residual = 0.0;         ///< of the result, in separations
  int iterations = 0;                ///< linear problems, those on columns too coarse included
  double corrected = 0.0;            ///< ContactMobility::corrected_by(), of what is resolved
  double seconds = 0.0;              ///< wall time, those of the responses included
  /// Pairs that do not open under their own force, or under no forces of all of them, or only by
  /// more correction of the response than the solver's tolerance: what too few nodes do.
  std::vector<ComponentPair> unseen{};
};

/// Keeps the components of a scene at their minimum separation.
///
/// Contact is seen ahead by interferences() of the polygons of all components, which lie within
/// four thousandths of the separation of their curves, and resolved by resolve_contact() with the
/// mobility of the whole suspension and the gaps of the curves. Where a force acts, these are one
/// separation to a part in 1e5, or up to 1.016 separations where polygons and curves disagree on
/// which points are the closest. No state with too_close() pairs is accepted.
class SuspensionContact {
 public:
  /// Prepares the polygons of a scene.
  ///
  /// @param  solver  of a scene with [contact], which must outlive this
  explicit SuspensionContact(const SuspensionSolver& solver);

  /// Returns the least distance that curves keep.
  /// @return delta, length
  double separation() const { return separation_; }

  /// Finds pairs that are closer than the separation, or just at it.
  ///
  /// @param  configuration  where the components are
  /// @return                their gaps, length
  /// @throws ConfigurationError on overlap, naming all pairs and depths; and on narrower gaps
  ///                unless contact.allow_close
  CloserPairs admit_start(const Configuration& configuration) const;

  /// Tells how much pairs that began closer may close now: gaps that have opened stay open.
  ///
  /// @param  closer         of the start, or of the step before
  /// @param  configuration  where the components are now
  /// @return                pairs that are closer still
  CloserPairs widened(const CloserPairs& closer, const Configuration& configuration) const;

  /// Resolves contact in a stage.
  ///
  /// @param  stage     to resolve
  /// @param  response  mobility where forces act
  /// @param  closer    pairs that may come closer
  /// @return           outcome; its velocity is to be used only where its status is resolved
  /// @throws SolverError as ContactMobility does
  ContactOutcome resolve(const ContactStage& stage, ContactMobility& response,
                         const CloserPairs& closer) const;

  /// Adds the forces of contact to a solution.
  ///
  /// @param  free      solution without them, where they act
  /// @param  outcome   resolved
  /// @param  response  that resolve() was given
  /// @return           motions, loads, density with them
  Solution with_forces(Solution free, const ContactOutcome& outcome,
                       const ContactMobility& response) const;

  /// Measures how far a step moves components past each other that come near each other in it.
  ///
  /// @param  start     where it begins
  /// @param  velocity  of the step, as to_rate() packs it
  /// @param  dt        its length
  /// @return           largest way of a point of the one as the other sees it, over the ratio of
  ///                   area and perimeter of the smaller: half the radius of a disk
  double relative_displacement(const Configuration& start, const Eigen::VectorXd& velocity,
                               double dt) const;

  /// Lists pairs that do not keep their separation, by the closest points of the curves.
  ///
  /// @param  configuration  where the components are
  /// @param  closer         pairs that may come closer
  /// @return                pairs whose gap is narrower by more than 2e-5 separations, and the gaps,
  ///                        as text; empty where there is none
  std::string too_close(const Configuration& configuration, const CloserPairs& closer) const;

 private:
  bool is_free(std::size_t component) const;
  std::string names(std::size_t a, std::size_t b) const;
  std::vector<PolygonGap> gaps(const Configuration& configuration) const;
  double curve_gap(const PolygonGap& found, const Configuration& configuration) const;
  ContactRules rules(const CloserPairs& closer) const;
  ContactParty party(std::size_t component) const;

  const SuspensionSolver& solver_;
  double separation_;
  double polygon_separation_;  // with the sags of both
  ContactShapes shapes_;
};

/// @}

}  // namespace stokesbook
