#pragma once

#include <optional>
#include <vector>

#include <Eigen/SparseCore>

#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What loads on free bodies add to a solution.
struct LoadSolution {
  ComplexVector density;  ///< at all n nodes, length / time
  Completion completion;  ///< motions of free bodies, loads of all components on the fluid
};

/// Loads that were answered in earlier configurations: where solves for similar ones begin. The
/// latest come first; as many older ones are kept, as contact that is lost for a while comes back.
/// Loads and densities turn with the components, as most of what lasts does.
struct MobilityColumns {
  Eigen::MatrixXd loads;  ///< 3K x m, as ContactMobility takes them, but in components' frames
  Eigen::VectorXd flows;  ///< norms of their right-hand sides, m numbers, length / time
  DensityHistory densities{1};  ///< that answered them, a column each
  /// Residual that the answer to a load is taken to leave in a configuration a step later, of a
  /// load that has turned by a tenth at most.
  static constexpr double most_tolerance = 0.1;
  double tolerance = most_tolerance;  ///< relative residual that columns may leave next
};

/// Answers loads on free bodies of one configuration with the motions that they cause: the mobility
/// B, a column a solve, with all prescribed components at rest and no background flow.
///
/// Loads count in the order of to_state(), force and torque of every component; those on prescribed
/// components go to their supports and move nothing.
///
/// What is wanted in the end is the answer to one combination of the loads, whose weights depend on
/// the columns themselves. So columns need not be exact: refine() solves for the combination as
/// exactly as the solver does for everything else, corrects the columns by what was missing, and
/// the weights follow from these. A column is
/// - the factorised system's, where there is one;
/// - else that of an earlier configuration, where the load has hardly turned since: it costs
///   nothing, and so contact that lasts costs a few iterations a step, however many the pairs;
/// - else solved for to a residual of a hundredth, from the most similar answer.
///
/// Columns whose errors make the mobility indefinite are corrected for it by definite_correction():
/// up to a tenth of the solver's tolerance. Where that does not do they are solved for more closely,
/// and in the end taken as they are.
///
/// The residual of a combination tells how good columns are. Those that leave more than they were
/// taken to are solved for; and all are, ten times as closely, where refinements have taken as
/// many iterations as that will, or leave more from one to the next. The next configuration's may
/// leave ten times as much again.
class ContactMobility {
 public:
  /// Takes a solution; nothing is solved yet.
  ///
  /// @param  solver    of the scene, which must outlive the response
  /// @param  solution  whose system is solved for loads
  /// @param  earlier   loads that were answered in a configuration before
  /// @param  exact     relative residual of what is solved exactly; none: the plan's
  ContactMobility(const SuspensionSolver& solver, const Solution& solution,
                  MobilityColumns earlier = {}, std::optional<double> exact = {});

  /// Solves for the motions under some loads.
  ///
  /// A load that was answered before, in this or an earlier call, is not solved for again.
  /// @param  loads  3K x m, forces / length and torques
  /// @return        3K x m velocities of all components, zero for prescribed ones
  /// @throws SolverError when GMRES does not converge
  /// @throws std::invalid_argument when loads in an unbounded fluid without gauge or prescribed
  ///                component do not balance
  /// @par Accuracy  residual of a tenth of the load's own flow, to that of the solver by tighten();
  ///                forces found with refine(), @ref claim_12_10
  /// @par Cost      a solve for each load that is new and unlike all others, @ref claim_12_17; back
  ///                substitutions only where the system is factorised
  Eigen::MatrixXd operator()(const Eigen::SparseMatrix<double>& loads);

  /// Makes the combination of the latest columns exact: its residual is that which the solver
  /// allows of the scene's own flow, or of the flow of the loads where that is stronger.
  ///
  /// What is missing is added to the columns in proportion to their weights, the least change that
  /// makes their combination right (Broyden's), so that they answer alike next time.
  /// @param  multipliers  m numbers, one a column of the latest loads; or none
  /// @return              true when columns have changed, or are to be solved for more closely;
  ///                      false when the combination is as exact as it gets
  /// @throws SolverError when GMRES does not converge
  /// @par Cost      a solve; none where multipliers have hardly changed
  bool refine(const Eigen::VectorXd& multipliers);

  /// Solves for columns ten times as closely from now on, those answered so far included.
  ///
  /// @return  false when they were as exact before as the solver makes everything else
  bool tighten();

  /// Adds up the solutions of the latest call.
  ///
  /// @param  multipliers  m numbers, one a column of the loads
  /// @return              their combination
  LoadSolution combined(const Eigen::VectorXd& multipliers) const;

  /// Keeps corrections by definite_correction() from now on, however large.
  ///
  /// @return  false when they were kept before
  bool keep_correction();

  /// Tells how much of the combination of the latest columns is a correction.
  ///
  /// @param  multipliers  m numbers, one a column of the loads
  /// @return              largest velocity of a component, over that of the scene's flow or that of
  ///                      the combination where this is larger; angular ones times the radius of
  ///                      gyration
  double corrected_by(const Eigen::VectorXd& multipliers) const;

  /// Returns all answers, for a configuration to come.
  /// @return loads; those of before where nothing was asked
  MobilityColumns columns() const;

  /// Counts what was done so far.
  /// @return solves, iterations and applications
  const SolveCost& cost() const { return cost_; }

  /// Counts solves.
  /// @return columns and combinations solved for
  int solves() const { return solves_; }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Column {
    Eigen::SparseVector<double> load;
    Eigen::SparseVector<double> forces;  // the same, torques over a component's radius of gyration
    ComplexVector density;
    std::vector<RigidMotion> motions{};
    double tolerance = 1.0;  // of its residual, as far as is known
    double flow = 0.0;       // norm of its right-hand side, about that of the earlier load's
  };
  /// @endcond
  void begin();
  std::size_t find_or_solve(Column asked);
  static double similarity(const Column& p, const Column& q);
  void reuse_similar(Column& asked) const;
  void solve_by_factors(Column& asked) const;
  void solve_to_tolerance(Column& asked, double separation);
  void complete(Column& answer, double flow) const;
  GmresResult solve(const ComplexVector& rhs, double tolerance, const ComplexVector& guess);
  bool refine_combination(const Eigen::VectorXd& multipliers);
  Eigen::VectorXd weights(const Eigen::VectorXd& multipliers) const;
  double residual_bound(const Eigen::VectorXd& weights) const;
  double fastest(const Eigen::VectorXd& velocities) const;
  Closure closure(const Eigen::SparseVector<double>& load) const;
  Eigen::SparseVector<double> combined_load(const Eigen::VectorXd& multipliers) const;

  const SuspensionSolver& solver_;
  Configuration configuration_;
  Discretisation discretisation_;
  MobilityColumns earlier_;
  double exact_;      // relative residual
  double tolerance_;  // of columns
  std::shared_ptr<const LinearSystem> discrete_;
  double flow_ = 0.0;             // norm of its own right-hand side, when it is needed
  double velocity_scale_;         // largest velocity of the scene's flow
  Eigen::VectorXd over_lengths_;  // what makes forces of loads, 1 / length for torques; 0 where
                                  // supports bear them
  std::vector<Column> earlier_columns_;  // earlier answers on the nodes of this configuration
  std::vector<Column> columns_;          // of all loads so far
  std::vector<std::size_t> latest_;      // those of the latest call's columns
  Eigen::MatrixXd velocities_;           // that they cause
  Eigen::MatrixXd correction_;           // of these velocities
  double most_correction_;               // by which it may move components, over the velocity scale
  bool corrects_ = true;                 // at all
  Eigen::VectorXd refined_;              // weights of the answers whose combination is exact
  double missing_ = 0.0;                 // residual that the combination had before that
  double allowed_ = 0.0;                 // of these weights' combination
  int spent_ = 0;  // iterations of refinements since then or the latest new load
  SolveCost cost_;
  int solves_ = 0;
};

/// @}

}  // namespace stokesbook
