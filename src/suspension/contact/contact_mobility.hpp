#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Columns of the contact mobility in an earlier configuration, from which solves for similar loads
/// begin. Loads and densities are stored in the frames of their components, in which they change
/// little while a contact lasts.
struct MobilityColumns {
  Eigen::MatrixXd loads;      ///< 3K x m, as ContactMobility takes them, but in components' frames
  Eigen::VectorXd rhs_norms;  ///< norms of their right-hand sides, m numbers, length / time
  DensityHistory densities{1};  ///< densities of their solutions, a column each
  /// Relative residual that a reused column is assumed to have one step later, if its load has
  /// turned by a tenth at most.
  static constexpr double most_tolerance = 0.1;
  double tolerance = most_tolerance;  ///< relative residual that columns may have next
};

/// Computes the least change of motions that makes a computed mobility positive definite.
///
/// Loads do positive work on the motions that they cause: the matrix \f$ F^TV \f$ is symmetric and
/// positive definite. Errors of the motions may make the computed matrix indefinite if some loads
/// hardly move anything, such as the forces across three gaps around trapped fluid; the
/// complementarity problem may then have no solution. All eigenvalues of the symmetric part, scaled
/// to a unit diagonal, are increased to the modulus of the most negative one, which is a lower
/// bound for the errors.
/// @param  loads  F, D x m, in units in which all components of a load are comparable
/// @param  works  \f$ F^TV \f$, m x m, of the motions V under these loads
/// @return        change of V, D x m; zero if the matrix is positive definite, or if a diagonal
///                entry is not positive, which no small change repairs
/// @par Cost      a Cholesky factorisation of an m x m matrix; eigenvectors if it fails
Eigen::MatrixXd definite_correction(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& works);

/// The mobility B of one configuration for contact forces: maps loads on free bodies to the motions
/// that they cause, with all prescribed components at rest and no background flow.
///
/// Loads are ordered as to_state() orders velocities: force and torque of every component. Loads on
/// prescribed components go to their supports and move nothing.
///
/// The step requires B for one combination of loads, whose weights depend on the columns
/// themselves. Columns may therefore be inexact: refine() solves for the combination as accurately
/// as the solver solves everything else, corrects the columns by the difference, and the weights
/// follow from the corrected columns. A column is
/// - that of the factorised system, if there is one;
/// - or that of an earlier configuration, if the load has hardly turned since. It costs nothing, so
///   that contact that lasts costs a few iterations a step, for any number of pairs;
/// - or the result of a solve to a relative residual of a hundredth, which begins with the most
///   similar column.
///
/// Errors of the columns may make the mobility indefinite: definite_correction() corrects them, by
/// up to a tenth of the solver's tolerance. If a larger correction is required, the columns are
/// solved to a tighter tolerance, and in the end used with their correction, however large.
///
/// The residual of a combination shows the quality of the columns. Columns with a larger residual
/// than assumed are solved for, and all columns are tightened when refinements take too many
/// iterations or diverge. The columns of the next configuration may have a residual ten times as
/// large.
class ContactMobility {
 public:
  /// Takes a solution, whose system is solved for loads, and the columns of an earlier
  /// configuration; nothing is solved yet. The solver must outlive the mobility.
  ///
  /// @param  exact  relative residual of combinations; none: that of the plan
  ContactMobility(const SuspensionSolver& solver, const Solution& solution,
                  MobilityColumns earlier = {}, std::optional<double> exact = {});

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
  /// columns in proportion to their weights: Broyden's update, the least change of the columns that
  /// makes their combination right.
  /// @param  multipliers  m numbers, one a column of the latest loads; or none
  /// @return              true if columns have changed, or will be solved to a tighter tolerance;
  ///                      false if the combination is as accurate as possible
  /// @par Cost      a solve; none if the multipliers have hardly changed
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
  MobilityColumns columns() const;

  const SolveCost& cost() const { return cost_; }  ///< returns the work so far
  int solves() const { return solves_; }  ///< counts the columns and combinations solved for

 private:
  struct Column {
    Eigen::SparseVector<double> load;
    Eigen::SparseVector<double> scaled_load;  // torques over the radius of gyration
    ComplexVector density;
    std::vector<RigidMotion> motions{};
    double tolerance = 1.0;  // estimated relative residual
    double rhs_norm = 0.0;   // norm of the right-hand side; of the earlier one for reused columns
  };
  std::size_t find_or_add(Column column);
  void reuse_similar(Column& column) const;
  void solve_by_factors(Column& column) const;
  void solve_to_tolerance(Column& column, double angle);
  void complete(Column& column, double rhs_norm) const;
  GmresResult run_gmres(const ComplexVector& rhs, double tolerance, const ComplexVector& guess);
  bool refine_combination(const Eigen::VectorXd& multipliers);
  Eigen::VectorXd column_weights(const Eigen::VectorXd& multipliers) const;
  double residual_bound(const Eigen::VectorXd& weights) const;
  std::pair<Eigen::SparseVector<double>, ComplexVector> combine(
      const Eigen::VectorXd& multipliers) const;

  const SuspensionSolver& solver_;
  Solution solution_;
  MobilityColumns earlier_;
  double combination_tolerance_;         // relative residual of combinations
  double column_tolerance_;              // relative residual of columns
  double flow_norm_;                     // norm of the scene's own right-hand side
  Eigen::VectorXd load_scales_;          // factors from loads to scaled loads
  std::vector<Column> earlier_columns_;  // columns of earlier configurations, on the present nodes
  std::vector<Column> columns_;          // columns of all loads so far
  std::vector<std::size_t> latest_columns_;  // columns of the loads of the latest call
  Eigen::MatrixXd velocities_;               // velocities of these columns
  Eigen::MatrixXd correction_;  // correction of these velocities, by definite_correction()
  double most_correction_;      // largest motion of the correction, over the velocity scale
  bool corrects_ = true;        // false: columns are used without a correction
  Eigen::VectorXd combination_weights_;  // weights of the latest combination that was solved for
  double combination_residual_ = 0.0;    // residual of that combination before its solve
  double allowed_residual_ = 0.0;        // residual that it may have
  int refinement_iterations_ = 0;        // iterations of refinements since the latest new load
  SolveCost cost_;
  int solves_ = 0;
};

}  // namespace stokesbook
