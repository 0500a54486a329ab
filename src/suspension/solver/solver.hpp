#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "scene/scene.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/density_decay.hpp"
#include "suspension/nodes/first_nodes.hpp"
#include "suspension/solver/flow.hpp"
#include "suspension/solver/instant_problem.hpp"
#include "suspension/solver/solution.hpp"
#include "suspension/system/error_estimate.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Guesses the density on the nodes of a discretisation; empty: no guess, GMRES starts from zero.
using DensityGuess = std::function<ComplexVector(const Discretisation&)>;

/// The judgement of a solution that includes contact forces.
struct LoadedCheck {
  ErrorEstimate estimate;  ///< of its motions and loads
  Resolutions needed;      ///< resolutions required; those of the solution if they suffice
  double gmres_tolerance;  ///< tolerance required: tighter than that of the solution if the nodes
                           ///< suffice but the tolerance does not
};

/// Solves a scene for any configuration of its components.
///
/// A configuration passes through gaps, resolution, problem, linear system, GMRES, completion and
/// error estimate; if the estimate exceeds the tolerance, the solve starts again with a finer
/// resolution. Discretised shapes are shared between solves. Everything else is computed anew and
/// depends on the configuration alone.
/// @par Accuracy  scene.solver.tolerance by estimate_error(), @ref claim_12_3, or a SolverError
class SuspensionSolver {
 public:
  /// Plans a scene and discretises its shapes.
  ///
  /// @param  scene  to be solved
  /// @throws std::invalid_argument when a number of nodes is odd or < 4
  /// @throws SolverError when shapes with automatic nodes require more nodes than "auto" allows,
  ///                and by separation_error()
  /// @par Cost      that of DiscretisationCache::get() a distinct shape, node count and kind
  explicit SuspensionSolver(const Scene& scene);

  /// Returns the instant at which the scene starts.
  /// @return the scene's poses, bodies first, then walls; amplitude 1
  Instant start() const;

  /// Returns the least gap that contact maintains.
  /// @return length; 0 in scenes without contact
  double separation() const;

  /// Solves for the motions of free bodies and the loads on all others, and estimates their error.
  ///
  /// Components with automatic nodes get the nodes that shapes and gaps require, and more while the
  /// estimate exceeds the tolerance. If the nodes suffice, the GMRES tolerance is tightened
  /// instead.
  /// @param  instant  poses and flow amplitude
  /// @param  guess    density with which GMRES begins
  /// @param  least    lower bounds for automatic node numbers; empty: none
  /// @return          density, motions and loads of all components, and the error estimate
  /// @throws ConfigurationError when components overlap, when shapes or gaps are not resolved, and
  ///                when no node number within the limits of node_choice.hpp meets the tolerance
  /// @throws SolverError on net flux, net force without gauge, a gauge length not
  ///                large against held components, a preconditioner that is singular, no
  ///                convergence, and numbers that are not finite
  /// @par Cost      find_gaps(), one application of SuspensionOperator and preconditioner an
  ///                iteration of GMRES, and estimate_error(); again for each finer resolution
  Solution solve(const Instant& instant, const DensityGuess& guess = {},
                 const Resolutions& least = {}) const;

  /// Estimates the error of a solution to which contact forces were added.
  ///
  /// @param  loaded           solution whose density and loads include the contact forces
  /// @param  gmres_tolerance  to which the contact forces were solved
  /// @return                  the estimate, and the effort of the next solve if the estimate
  ///                          exceeds the tolerance; the same effort if more would not help
  /// @par Cost      that of discretise() and of estimate_error()
  LoadedCheck check_loaded(const Solution& loaded, double gmres_tolerance) const;

  /// Solves a configuration near one that was solved before, without an error estimate: for the
  /// stages of a time step, and for steps between estimates.
  ///
  /// @param  instant  poses and flow amplitude
  /// @param  earlier  resolution that sufficed before; gaps that have closed require more
  /// @param  guess    as in solve()
  /// @return          density, motions and loads of all components
  /// @throws SolverError as solve() does, except for estimates
  /// @par Cost      find_gaps(), and one application of SuspensionOperator and preconditioner an
  ///                iteration of GMRES
  Solution solve_nearby(const Instant& instant, const Resolutions& earlier,
                        const DensityGuess& guess = {}) const;

  /// Solves for every component alone in the earlier flow of all others: the lagged, "locally
  /// implicit" coupling, one sweep of block Jacobi,
  /// \f$ \eta = \eta' + M^{-1}(b - A\eta') \f$ with the block diagonal M of A.
  ///
  /// The estimate includes the error of the sweep, and may exceed the tolerance. The residual is
  /// that of the earlier density.
  /// @param  instant  poses and flow amplitude
  /// @param  guess    the earlier density, not empty
  /// @return          density, motions and loads of all components, and the error estimate
  /// @throws SolverError as solve() does, except for estimates and convergence
  /// @par Cost      find_gaps(), one application of SuspensionOperator and preconditioner, and
  ///                estimate_error()
  /// @par Not for   a plan without block_diagonal
  Solution solve_lagged(const Instant& instant, const DensityGuess& guess) const;

  /// Evaluates the fluid's velocity in a solution.
  ///
  /// @param  solution  of any instant
  /// @param  points    m points in the fluid or on its boundary, length
  /// @return           m velocities, length / time
  /// @par Cost      m n kernel evaluations for n nodes in all
  /// @par Not for   points inside bodies; points near the boundary if solver.near_singular is off
  ComplexVector velocity(const Solution& solution, const ComplexVector& points) const {
    return flow_velocity(scene_, plan_, solution, points);
  }

  /// Prepares a solution for the evaluation of stresses and powers, without the background flow.
  ///
  /// @param  solution  of any instant
  /// @return           the disturbance, near the boundary by the Cauchy scheme for any value of
  ///                   solver.near_singular
  SolvedFlow disturbance(const Solution& solution) const {
    return stokesbook::disturbance(scene_, plan_, solution);
  }

  /// Solves under the loads of a solution with a quarter more nodes, to a hundredth of the GMRES
  /// tolerance.
  ///
  /// A quantity without an error estimate of its own, such as a traction, can be computed from both
  /// solutions: twice the difference estimates the error of the given solution.
  /// @param  solution  with or without contact forces
  /// @return           the finer solution, without an error estimate
  /// @throws SolverError when GMRES does not converge, or there are too many nodes
  /// @par Cost      that of a solve with a good guess
  Solution refined(const Solution& solution) const;

  /// Evaluates pressure over viscosity, vorticity and strain in a solution, the background's
  /// included.
  ///
  /// The pressure is zero at infinity; in an enclosed fluid it is known up to a constant only.
  /// @param  solution  of any instant
  /// @param  points    m points in the fluid, or nodes of its boundary, length
  /// @return           m values, 1 / time
  /// @par Cost      m n kernel evaluations for n nodes in all
  /// @par Not for   points inside bodies
  std::vector<FlowDerivatives> derivatives(const Solution& solution,
                                           const ComplexVector& points) const {
    return flow_derivatives(scene_, plan_, solution, points);
  }

  /// Poses the boundary value problem of an instant at a resolution.
  ///
  /// @param  instant         poses and flow amplitude
  /// @param  discretisation  of each component, such as a solution's
  /// @return                 bodies, then walls, with their nodes, loads and velocities
  StokesProblem problem(const Instant& instant, const Discretisation& discretisation) const {
    return instant_problem(scene_, instant, discretisation);
  }

  /// Builds the linear system of an instant at a resolution.
  ///
  /// @param  instant         poses and flow amplitude
  /// @param  discretisation  of each component
  /// @return                 problem, operator, and the preconditioner of the plan
  /// @throws SolverError when the preconditioner is singular, as for a held component whose size is
  ///                at the degenerate scale of flow.gauge_length
  LinearSystem linear_system(const Instant& instant, const Discretisation& discretisation) const;

  /// Recommends nodes for every component, so that shapes and the gaps of a configuration meet the
  /// tolerance.
  ///
  /// @param  configuration  where the components are
  /// @param  gaps           in it, as gaps() finds them
  /// @return                multiples of 16, one a component; 0 where no number up to 4096 resolves
  ///                        a shape, and no gap requires more
  /// @par Cost      that of nodes_for_shape() a distinct shape
  std::vector<int> recommended_nodes(const Configuration& configuration,
                                     const std::vector<Gap>& gaps) const {
    return stokesbook::recommended_nodes(discretisation_, scene_.solver.tolerance, configuration,
                                         gaps);
  }

  /// Chooses the resolution with which solve() begins.
  ///
  /// @param  configuration  where the components are
  /// @param  gaps           in it, as gaps() finds them
  /// @return                given node counts as they are; automatic ones from shapes and gaps
  Resolutions first_resolutions(const Configuration& configuration,
                                const std::vector<Gap>& gaps) const {
    return stokesbook::first_resolutions(scene_, discretisation_, configuration, gaps);
  }

  /// Finds the gaps of a configuration that may require nodes, including overlaps.
  ///
  /// @param  configuration  where the components are
  /// @return                in ascending order, as find_gaps() returns them
  /// @par Cost      that of find_gaps()
  std::vector<Gap> gaps(const Configuration& configuration) const;

  /// Discretises the shape of each component, or returns what an earlier call built.
  ///
  /// @param  resolutions  of each component
  /// @return              bodies, then walls, in the scene's order
  /// @throws std::invalid_argument when a number of nodes is odd or < 4
  /// @par Cost      that of DiscretisationCache::get() a component
  Discretisation discretise(const Resolutions& resolutions) const;

  /// Returns the scene.
  /// @return the scene that was planned
  const Scene& scene() const { return scene_; }

  /// Returns the plan.
  /// @return the decisions, and their reasons
  const Plan& plan() const { return plan_; }

  /// Returns the discretisation that depends on no configuration.
  /// @return bodies, then walls, in the scene's order; where nodes are automatic, with as many as
  ///         the shape alone requires
  const Discretisation& discretisation() const { return discretisation_; }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Effort {
    Resolutions resolutions;
    double gmres_tolerance;
    DensityGuess guess;
    int increases_without_tail = 0;  // how often nodes were added although no tail was large
  };
  struct System {
    Instant instant;
    Discretisation discretisation;
    std::shared_ptr<const LinearSystem> discrete;
  };
  /// @endcond
  Solution attempt(const Instant& instant, const std::vector<Gap>& gaps,
                   const Effort& effort) const;
  ErrorEstimate estimate(const LinearSystem& discrete, const Solution& solution) const;
  Resolutions finer_than(const Solution& solution) const;
  Effort more_effort(const Effort& effort, const std::vector<TailEstimate>& tails,
                     double error) const;
  System system(const Instant& instant, const std::vector<Gap>& gaps,
                const Resolutions& resolutions) const;
  std::vector<Gap> open_gaps(const Configuration& configuration) const;
  Solution converged(const System& system, double gmres_tolerance,
                     const ComplexVector& guess) const;

  Scene scene_;
  Plan plan_;
  std::shared_ptr<DiscretisationCache>
      cache_;  // shared by copies; solve() is const, and may fill it
  Discretisation discretisation_;
  Resolutions least_;  // that resolve the softest mode of each component, for estimates
};

/// @}

}  // namespace stokesbook
