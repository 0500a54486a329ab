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

/// Where a force of contact acts, and its direction on a component.
struct ActingForce {
  Complex point;   ///< length
  Complex normal;  ///< unit
};

/// A row as the loop of the nonlinear problem names and weighs it.
struct GapConstraint {
  std::size_t a,                          ///< a component
      b;                                  ///< the other, after it
  ContactRow row;                         ///< by the polygons
  double gap = 0.0;                       ///< at the end, over the separation of the curves, length
  std::optional<ClosestPoints> points{};  ///< there, of the curves where the gap is theirs
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

/// How polygons and curves are kept apart, and which pairs concern contact.
struct ConstraintRules {
  ContactRules polygons;  ///< separations of the polygons, with the sags of both
  Separation curves;      ///< separations that are kept
  std::function<bool(std::size_t a, std::size_t b)> concerns;  ///< pairs that forces can move
};

/// The geometry of a stage as the loop of the nonlinear problem asks for it; remembers all rows
/// that it has returned.
///
/// Rows are those of interferences() of pairs that were violated at some velocity, where such a
/// pair had one at an earlier velocity, and where its curves come closer than at all of these. Their
/// gaps are those of the curves at the end of the step; forces act at the closest points of the
/// acting configuration, as those at the end of the step would cost an order.
class GapConstraints {
 public:
  /// Takes a stage.
  ///
  /// @param  stage           to resolve; must outlive the rows, as all arguments
  /// @param  discretisation  of all components
  /// @param  shapes          their polygons
  /// @param  rules           what keeps them apart
  GapConstraints(const ContactStage& stage, const Discretisation& discretisation,
                 const ContactShapes& shapes, const ConstraintRules& rules);

  /// Runs the loop, with the exact derivative of gaps, which converges fast, or else with that of
  /// the forces: its linear problems are symmetric, hence solvable, however far a step goes astray.
  ///
  /// @param  step  all but its rows
  /// @return       of the last loop, with the iterations of both, at most those of the stage
  ContactResult resolved(const ContactStep& step);

  /// Finds a row by its name.
  ///
  /// @param  key  of a row that was returned
  /// @return      as it was returned last
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
  std::set<ComponentPair> pressed_;                      // violated at some velocity
  std::map<ComponentPair, std::vector<RowKey>> places_;  // of its rows so far
  std::map<ContactKey, GapConstraint> seen_;
};

/// @}

}  // namespace stokesbook
