#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "stress/solved_flow.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/solution.hpp"
#include "suspension/system/error_estimate.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Guesses the density on the nodes of a discretisation; empty: no guess, GMRES starts from zero.
using DensityGuess = std::function<ComplexVector(const Discretisation&)>;

/// The judgement of a solution that includes contact forces.
struct LoadedCheck {
  ErrorEstimate estimate;  ///< estimate for its motions and loads
  Resolutions needed;      ///< resolutions required; those of the solution if they suffice
  double gmres_tolerance;  ///< tolerance required: tighter than that of the solution if the nodes
                           ///< suffice but the tolerance does not
};

/// Solves a scene for any configuration of its components.
///
/// Discretised shapes are shared between solves. Everything else is computed anew and depends on
/// the configuration alone.
/// @par Accuracy  scene.solver.tolerance by estimate_error(), @ref claim_12_3, or a SolverError
class SuspensionSolver {
 public:
  /// Plans a scene and discretises its shapes.
  ///
  /// @throws std::invalid_argument when a number of nodes is odd or < 4
  /// @throws SolverError when shapes with automatic nodes require more nodes than "auto" allows,
  ///                and by separation_error()
  explicit SuspensionSolver(const Scene& scene);

  /// Returns the instant at which the scene starts.
  Instant start() const;

  /// Returns the instant at which a run of the scene has a configuration. In a periodic cell, the
  /// instant replaces components on their paths by their images in the cell.
  Instant instant(Configuration configuration, const StepTime& time = {}) const;

  /// Returns the least gap that contact maintains, length; 0 in scenes without contact.
  double separation() const;

  /// Solves for the motions of free bodies and the loads on all others, and estimates their error.
  ///
  /// Components with automatic nodes get the nodes that shapes and gaps require, and more while the
  /// estimate exceeds the tolerance. If the nodes suffice, the GMRES tolerance is tightened
  /// instead.
  /// @param  least  lower bounds for automatic node numbers; empty: none
  /// @throws ConfigurationError when components overlap, when shapes or gaps are not resolved, and
  ///                when no allowed number of nodes meets the tolerance
  /// @throws SolverError by data_error(), and on a singular preconditioner, no convergence, and
  ///                numbers that are not finite
  /// @par Cost      find_gaps(), one application of SuspensionOperator and preconditioner per
  ///                iteration of GMRES, and estimate_error(); again for each finer resolution
  Solution solve(const Instant& instant, DensityGuess guess = {},
                 const Resolutions& least = {}) const;

  /// Estimates the error of a solution whose density and loads include contact forces.
  ///
  /// @param  gmres_tolerance  to which the contact forces were solved
  /// @return  the estimate, and resolutions and GMRES tolerance of the next solve if the estimate
  ///          exceeds the tolerance; those of `loaded` if more nodes or a tighter tolerance would
  ///          not help
  LoadedCheck check_loaded(const Solution& loaded, double gmres_tolerance) const;

  /// Solves a configuration near one that was solved before, without an error estimate: for the
  /// stages of a time step, and for steps between estimates.
  ///
  /// @param  earlier  resolution that sufficed before; gaps that have closed require more
  /// @param  tree     that of the earlier solution, which is used again if tree_lasts()
  /// @throws SolverError as solve() does, except for estimates
  Solution solve_nearby(const Instant& instant, const Resolutions& earlier,
                        const DensityGuess& guess = {}, const SharedTree& tree = {}) const;

  /// Solves for every component alone in the earlier flow of all others: the lagged, "locally
  /// implicit" coupling, one sweep of block Jacobi,
  /// \f$ \eta = \eta' + M^{-1}(b - A\eta') \f$ with the block diagonal M of A.
  ///
  /// The estimate includes the error of the sweep, and may exceed the tolerance. The residual is
  /// that of the earlier density.
  /// @param  guess    the earlier density, not empty
  /// @throws SolverError as solve() does, except for estimates and convergence
  /// @par Not for   a plan without block_diagonal
  Solution solve_lagged(const Instant& instant, const DensityGuess& guess) const;

  /// Solves under the loads of a solution with a quarter more nodes, to a hundredth of the GMRES
  /// tolerance, without an error estimate.
  ///
  /// A quantity without an error estimate of its own, such as a traction, can be computed from both
  /// solutions: twice the difference estimates the error of the given solution.
  /// @throws SolverError when GMRES does not converge, or there are too many nodes
  Solution solve_refined(const Solution& solution) const;

  /// Evaluates the fluid's velocity in a solution at m points in the fluid or on its boundary; in a
  /// periodic cell, also far from the cell.
  ///
  /// @par Cost      that of planned_sum()
  /// @par Not for   points inside bodies; points near the boundary if solver.near_singular is off
  ComplexVector velocity(const Solution& solution, const ComplexVector& points) const;

  /// Prepares a solution for the evaluation of stresses and powers, without the background flow;
  /// near the boundary by the Cauchy scheme for any value of solver.near_singular.
  SolvedFlow disturbance(const Solution& solution) const;

  /// Evaluates pressure over viscosity, vorticity and strain, 1 / time, in a solution, including
  /// the background, at m points in the fluid or at nodes of its boundary.
  ///
  /// The pressure is zero at infinity; in an enclosed fluid it is known up to a constant only. In a
  /// periodic cell it is that of SolvedFlow.
  /// @par Cost      that of planned_sum()
  /// @par Not for   points inside bodies
  std::vector<FlowDerivatives> derivatives(const Solution& solution,
                                           const ComplexVector& points) const;

  /// Poses the boundary value problem of an instant at a resolution, by instant_problem().
  StokesProblem problem(const Instant& instant, const Discretisation& discretisation) const {
    return instant_problem(scene_, instant, discretisation);
  }

  /// Builds the linear system of an instant at a resolution, by preconditioned_system().
  LinearSystem linear_system(const Instant& instant, const Discretisation& discretisation) const;

  /// Finds the gaps of a configuration that may require nodes, including overlaps, by find_gaps().
  ///
  /// @param  cell  that of the instant
  std::vector<Gap> gaps(const Configuration& configuration,
                        const std::optional<PeriodicCell>& cell = {}) const;

  /// Recommends nodes for every component by stokesbook::recommended_nodes().
  std::vector<int> recommended_nodes(const Configuration& configuration,
                                     const std::vector<Gap>& gaps) const {
    return stokesbook::recommended_nodes(discretisation_, scene_.solver.tolerance, configuration,
                                         gaps);
  }

  /// Chooses the resolution with which solve() begins, by stokesbook::first_resolutions().
  Resolutions first_resolutions(const Configuration& configuration,
                                const std::vector<Gap>& gaps) const {
    return stokesbook::first_resolutions(scene_, discretisation_, configuration, gaps);
  }

  /// Discretises the shape of each component by DiscretisationCache::get().
  Discretisation discretise(const Resolutions& resolutions) const;

  /// Returns the scene that was planned.
  const Scene& scene() const { return scene_; }

  /// Returns the decisions for the scene.
  const Plan& plan() const { return plan_; }

  /// Returns the discretisation that depends on no configuration: where nodes are automatic, with
  /// as many as the shape alone requires.
  const Discretisation& discretisation() const { return discretisation_; }

 private:
  struct Effort {
    Resolutions resolutions;
    double gmres_tolerance;
    bool operator==(const Effort&) const = default;
  };
  std::vector<Gap> find_open_gaps(const Instant& instant) const;
  LinearSystem assemble(const StokesProblem& problem, const Configuration& configuration,
                        const std::vector<Gap>& gaps, const Discretisation& discretisation,
                        const SharedTree& tree = {}) const;
  Solution prepare(const Instant& instant, const std::vector<Gap>& gaps,
                   const Resolutions& resolutions, const SharedTree& tree = {}) const;
  Solution solve_system(Solution prepared, double gmres_tolerance, const DensityGuess& guess) const;
  ErrorEstimate estimate_on_finer_nodes(const LinearSystem& discrete, const Solution& solution,
                                        double gmres_tolerance) const;
  Effort increase(const Effort& effort, const std::vector<TailEstimate>& tails, double error) const;
  Resolutions finer_than(const Solution& solution) const;
  double least_gmres_tolerance() const;

  Scene scene_;
  Plan plan_;
  std::shared_ptr<DiscretisationCache>
      cache_;  // shared by copies; solve() is const, and may fill it
  Discretisation discretisation_;
  Resolutions least_;  // nodes that resolve the softest mode of each component, for estimates
};

}  // namespace stokesbook
