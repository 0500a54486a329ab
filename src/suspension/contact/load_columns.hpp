#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Columns of the contact mobility in an earlier configuration, from which solves for similar loads
/// begin. Loads and densities are stored in the frames of their components, in which they change
/// little while a contact lasts.
struct MobilityColumns {
  /// How fast the density under a load changes in time, in the frames of the components.
  struct Drift {
    Eigen::VectorXd load{};     ///< 3K numbers, in components' frames; empty: unknown
    DensityHistory density{1};  ///< change of its density over time, length / time^2
  };

  Eigen::MatrixXd loads;      ///< 3K x m, as ContactMobility takes them, but in components' frames
  Eigen::VectorXd rhs_norms;  ///< norms of their right-hand sides, m numbers, length / time
  DensityHistory densities{1};  ///< densities of their solutions, a column each
  /// Relative residual that a reused column is assumed to have one step later, if its load has
  /// turned by a tenth at most.
  static constexpr double most_tolerance = 0.1;
  double tolerance = most_tolerance;  ///< relative residual that columns may have next
  double t = 0.0;                     ///< time of their configuration
  Drift drift{};                      ///< that of the latest combination of loads
};

/// The flow under one load.
struct LoadColumn {
  Eigen::SparseVector<double> load;         ///< 3K numbers
  Eigen::SparseVector<double> scaled_load;  ///< times LoadColumns::load_scales()
  ComplexVector density;                    ///< length / time
  std::vector<RigidMotion> motions{};       ///< of all components
  double tolerance = 1.0;                   ///< estimated relative residual
  double rhs_norm = 0.0;  ///< norm of the right-hand side; of the earlier one if it is reused
};

/// Where LoadColumns::find() has found columns.
struct FoundColumns {
  std::vector<std::size_t> columns;  ///< numbers of the columns, one for each load
  bool solved_again = false;         ///< whether one of them was known before, less accurately
};

/// Solves for the flows under loads in one configuration, at most once for each load.
///
/// A column is
/// - that of the factorised system, if there is one;
/// - or that of an earlier configuration, if the load has hardly turned since. It costs nothing, so
///   that contact that lasts costs a few iterations a step, for any number of pairs;
/// - or the result of a solve to a relative residual of a hundredth, which begins with the most
///   similar column.
class LoadColumns {
 public:
  /// Takes a solution, whose system is solved for loads, and the columns of an earlier
  /// configuration; nothing is solved yet. The solver must outlive the columns.
  ///
  /// @param  tightest  least relative residual that a column needs
  /// @param  t         time of the solution
  LoadColumns(const SuspensionSolver& solver, Solution solution, MobilityColumns earlier,
              double tightest, double t = 0.0);

  /// Finds the columns of m loads. Solves for those whose columns are not known from this or an
  /// earlier call, or not to the tolerance that now holds. Two loads that are nearly parallel take a
  /// tolerance that is tighter in proportion to the angle between them.
  ///
  /// @param  loads  3K x m, forces / length and torques
  /// @throws SolverError when GMRES does not converge
  FoundColumns find(const Eigen::SparseMatrix<double>& loads);

  /// Adds a change to the density of a column.
  /// @param  tolerance  the relative residual that the column has had, if it exceeds the estimate
  void correct(std::size_t column, const ComplexVector& change, double tolerance);

  /// Guesses how the density under a load differs from that of the earlier columns: it changes as
  /// it did before that, in proportion to the time and to the part of the load that has acted
  /// before, up to second order in time. Returns no numbers where nothing is known, or after
  /// remember_change().
  ComplexVector expected_change(const Eigen::SparseVector<double>& load) const;

  /// Remembers how the density under a load differs from that of the earlier columns. Further calls
  /// have no effect, as the columns are to be corrected by this change.
  void remember_change(const Eigen::SparseVector<double>& load, const ComplexVector& change);

  /// Divides the tolerance of all columns by ten from now on. Returns false if the tolerance was
  /// the tightest one already.
  bool tighten();

  /// Poses the problem of the same components at rest, under a load alone.
  StokesProblem problem_under(const Eigen::SparseVector<double>& load) const;

  /// Returns the right-hand side of this problem's system.
  ComplexVector rhs_under(const Eigen::SparseVector<double>& load) const;

  /// Solves the system of the solution by GMRES.
  /// @throws SolverError when GMRES does not converge
  GmresResult solve(const ComplexVector& rhs, double tolerance, const ComplexVector& guess);

  /// Returns all columns, for the next configuration; the earlier ones if none was computed. They
  /// may have a residual ten times as large.
  MobilityColumns for_next_configuration() const;

  /// Returns the factors that make all components of a load comparable: 1 for forces, 1 over the
  /// radius of gyration for torques, and 0 for loads that supports bear.
  const Eigen::VectorXd& load_scales() const { return load_scales_; }

  const Solution& solution() const { return solution_; }  ///< returns that of the constructor
  double tightest() const { return tightest_; }           ///< returns that of the constructor
  /// Returns a column by the number that find() has returned.
  const LoadColumn& operator[](std::size_t column) const { return columns_[column]; }
  std::size_t size() const { return columns_.size(); }  ///< counts the columns
  const SolveCost& cost() const { return cost_; }       ///< returns the work so far
  int solves() const { return solves_; }                ///< counts the calls of solve()

 private:
  std::size_t find_or_add(LoadColumn column);
  void reuse_similar(LoadColumn& column) const;
  void solve_by_factors(LoadColumn& column) const;
  bool solve_to_tolerance(LoadColumn& column, double angle);
  void complete(LoadColumn& column, double rhs_norm) const;
  double elapsed() const { return t_ - earlier_.t; }

  const SuspensionSolver& solver_;
  Solution solution_;
  MobilityColumns earlier_;
  double tightest_;
  double tolerance_;  // relative residual of columns
  double t_;          // time of the solution; earlier_ has the same time where no change is to be
                      // foreseen: without earlier columns, and after remember_change()
  Eigen::VectorXd load_scales_;
  std::vector<LoadColumn> earlier_columns_;  // columns of earlier configurations, on these nodes
  std::vector<LoadColumn> columns_;          // columns of all loads so far
  SolveCost cost_;
  int solves_ = 0;
};

}  // namespace stokesbook
