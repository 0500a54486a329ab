#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "suspension/contact/load_columns.hpp"

namespace stokesbook {

/// The mobility B of one configuration for contact forces: maps loads on free bodies to the motions
/// that they cause, with all prescribed components at rest and no background flow.
///
/// Loads are ordered as to_state() orders velocities: force and torque of every component. Loads on
/// prescribed components go to their supports and move nothing.
///
/// The step requires B for one combination of loads, whose weights depend on the columns
/// themselves. The columns, LoadColumns, may therefore be inexact: refine() solves for the
/// combination as accurately as the solver solves everything else, corrects the columns by the
/// difference, and the weights follow from the corrected columns.
///
/// Errors of the columns may make the mobility indefinite: definite_correction() corrects them, by
/// up to a hundredth of the solver's tolerance. If a larger correction is required, the columns are
/// solved to a tighter tolerance, and in the end used with their correction, however large.
///
/// The residual of a combination shows the quality of the columns. Columns with a larger residual
/// than assumed are solved for, and all columns are tightened when refinements take too many
/// iterations or diverge.
class ContactMobility {
 public:
  /// Takes a solution, whose system is solved for loads, and the columns of an earlier
  /// configuration; nothing is solved yet. The solver must outlive the mobility.
  ///
  /// @param  exact  relative residual of combinations; none: that of the plan
  /// @param  t      time of the solution
  ContactMobility(const SuspensionSolver& solver, const Solution& solution,
                  MobilityColumns earlier = {}, std::optional<double> exact = {}, double t = 0.0);

  /// Returns the motions under some loads. A load whose column is known from this or an earlier
  /// call is not solved for again.
  ///
  /// @param  loads  3K x m, forces / length and torques
  /// @return        3K x m velocities of all components, zero for prescribed ones
  /// @throws SolverError when GMRES does not converge
  /// @throws std::invalid_argument when loads in an unbounded fluid without gauge length and
  ///                prescribed component do not balance
  /// @par Accuracy  relative residual of a tenth, down to that of the solver by tighten(); contact
  ///                forces found with refine(), @ref claim_12_10
  /// @par Cost      a solve for each load that differs from all others, @ref claim_12_17; back
  ///                substitutions if the system is factorised
  Eigen::MatrixXd operator()(const Eigen::SparseMatrix<double>& loads);

  /// Makes the combination of the latest columns accurate: its residual is that which the solver
  /// allows for the scene's own flow, or for the flow of the loads if that is stronger.
  ///
  /// The difference between the accurate combination and that of the columns is added to the
  /// columns in proportion to the part of their weights that no earlier combination has had: this
  /// is Broyden's projected update, the least change of the columns that makes this combination
  /// right and keeps the earlier ones so.
  /// @param  multipliers  m numbers, one a column of the latest loads; or none
  /// @return              true if columns have changed, or will be solved to a tighter tolerance;
  ///                      false if the combination is as accurate as possible
  /// @par Cost      a solve; none if the multipliers have hardly changed
  /// @sa source: Gay and Schnabel, Nonlinear Programming 3 (1978), 245
  bool refine(const Eigen::VectorXd& multipliers);

  /// Divides the tolerance of all columns by ten from now on. Returns false if the tolerance was
  /// that of the solver already.
  bool tighten();

  /// Adds the combination of the latest columns with m multipliers to the solution: to its motions,
  /// loads and density.
  Solution loaded_solution(const Eigen::VectorXd& multipliers) const;

  /// Accepts corrections of any size by definite_correction() from now on. Returns false if they
  /// were accepted before.
  bool accept_any_correction();

  /// Measures the part of the combination of the latest columns that definite_correction() has
  /// added: the largest added velocity of a component, over the velocity scale of the scene, or
  /// over the largest velocity of the combination if that is larger. Angular velocities are
  /// multiplied by the radius of gyration.
  double relative_correction(const Eigen::VectorXd& multipliers) const;

  /// Returns all columns, for the next configuration; the earlier ones if none was computed.
  MobilityColumns columns() const { return columns_.for_next_configuration(); }

  const SolveCost& cost() const { return columns_.cost(); }  ///< returns the work so far
  int solves() const { return columns_.solves(); }  ///< counts the columns and combinations solved

 private:
  bool refine_combination(const Eigen::VectorXd& multipliers);
  Eigen::VectorXd column_weights(const Eigen::VectorXd& multipliers) const;
  Eigen::VectorXd add_direction(const Eigen::VectorXd& weights);
  double residual_bound(const Eigen::VectorXd& weights) const;
  std::pair<Eigen::SparseVector<double>, ComplexVector> combine(
      const Eigen::VectorXd& multipliers) const;

  LoadColumns columns_;                      // columns of all loads so far
  std::vector<std::size_t> latest_columns_;  // columns of the loads of the latest call
  Eigen::MatrixXd velocities_;               // velocities of these columns
  Eigen::MatrixXd correction_;  // correction of these velocities, by definite_correction()
  double most_correction_;      // largest motion of the correction, over the velocity scale
  bool corrects_ = true;        // false: columns are used without a correction
  double flow_norm_;            // norm of the scene's own right-hand side
  Eigen::VectorXd combination_weights_;  // weights of the latest combination that was solved for
  double combination_residual_ = 0.0;    // residual of that combination before its solve
  Eigen::MatrixXd directions_;     // orthonormal; span the weights of all accurate combinations
  double allowed_residual_ = 0.0;  // residual that it may have
  int refinement_iterations_ = 0;  // iterations of refinements since the latest new load
};

}  // namespace stokesbook
