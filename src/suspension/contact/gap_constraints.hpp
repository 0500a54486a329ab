#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "near_singular/closest_points.hpp"
#include "suspension/contact/contact.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The point and the direction of a contact force.
struct ActingForce {
  Complex point;   ///< length
  Complex normal;  ///< unit vector, of the force on a
};

/// A constraint of a stage: the gap of two components must not be negative.
struct GapConstraint {
  std::size_t a,                          ///< a component
      b;                                  ///< another component, b > a
  ContactRow row;                         ///< of the polygons
  double gap = 0.0;                       ///< at the end of the step, minus the separation; length
  std::optional<ClosestPoints> points{};  ///< of the curves there, if they measure the gap
  ActingForce on_a{};                     ///< by the curves
};

/// Finds the straight paths of components.
///
/// @param  start     where they begin
/// @param  velocity  3K numbers, packed as a rate
/// @param  dt        duration, time
/// @return           paths of K components
std::vector<RigidPath> straight_paths(const Configuration& start, const Eigen::VectorXd& velocity,
                                      double dt);

/// The separations of polygons and of curves, and the pairs that contact concerns.
struct ConstraintRules {
  ContactRules polygons;  ///< separations of the polygons, with the sags of both
  Separation curves;      ///< separations of the curves
  std::function<bool(std::size_t a, std::size_t b)> concerns;  ///< true if forces can move the pair
};

/// The gap functions of a stage and their Jacobian, as the contact loop of chapter 11 requires
/// them; remembers all constraints that it has returned.
///
/// The pairs with constraints are those that were violated at some velocity. Their constraints are
/// those that interferences() finds, those that they had at an earlier velocity, and the closest
/// point of their curves if that is nearer than all of these. A gap is that of the curves at the
/// end of the step. Forces act at the closest points of the acting configuration; forces at the
/// closest points of the end would lower the order of the method by one.
class GapConstraints {
 public:
  /// Takes a stage. All arguments must outlive the constraints.
  ///
  /// @param  stage           to resolve
  /// @param  discretisation  of all components
  /// @param  shapes          their polygons
  /// @param  rules           separations that are kept
  GapConstraints(const ContactStage& stage, const Discretisation& discretisation,
                 const ContactShapes& shapes, const ConstraintRules& rules);

  /// Runs the contact loop with the exact Jacobian of the gaps, which converges fast; if that
  /// fails, with the Jacobian of the forces, whose linear problems are symmetric and have
  /// solutions.
  ///
  /// @param  step  without its rows
  /// @return       result of the last loop, with the iterations of both, at most those of the stage
  ContactResult resolved(const ContactStep& step);

  /// Finds a constraint by its key.
  ///
  /// @param  key  of a constraint that was returned
  /// @return      the constraint as it was returned last
  const GapConstraint& seen(const ContactKey& key) const { return seen_.at(key); }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  enum class Linearisation { exact, symmetric };
  /// @endcond
  ContactResult resolved(ContactStep step, Linearisation linearisation, int most_iterations);
  ContactRows rows(const Eigen::VectorXd& velocity, Linearisation linearisation);
  std::vector<GapConstraint> pressed_rows(const Eigen::VectorXd& velocity,
                                          const Configuration& end);
  void look_for_missed(const std::vector<GapConstraint>& rows, const Configuration& end);
  void add_former(std::vector<GapConstraint>& rows, const Configuration& end) const;
  void measure(GapConstraint& row, const Configuration& end) const;
  bool is_violated(const std::vector<GapConstraint>& rows) const;
  double sags(const GapConstraint& row) const;
  SmoothCurve curve(std::size_t component, const Configuration& at) const;
  ClosestPoints closest(const RowKey& key, const Configuration& at) const;

  const ContactStage& stage_;
  const Discretisation& discretisation_;
  const ContactShapes& shapes_;
  const ConstraintRules& rules_;
  std::set<ComponentPair> pressed_;                      // pairs violated at some velocity
  std::map<ComponentPair, std::vector<RowKey>> places_;  // of their constraints so far
  std::map<ContactKey, GapConstraint> seen_;
};

/// @}

}  // namespace stokesbook
