#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "closure/closure.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_correction.hpp"
#include "scene/scene.hpp"
#include "stress/solved_flow.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/density_decay.hpp"
#include "suspension/system/error_estimate.hpp"
#include "suspension/system/linear_system.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Guesses the density on the nodes of a discretisation; empty: no guess, GMRES starts from zero.
using DensityGuess = std::function<ComplexVector(const Discretisation&)>;

/// What a solution has cost, attempts at fewer nodes included.
struct SolveCost {
  int gmres_iterations = 0;  ///< of all solves for motions and loads
  int matvecs = 0;           ///< applications of the operator, those of error estimates included
  /// Adds what was done elsewhere.
  /// @param  other  counts
  /// @return        the sum
  SolveCost& operator+=(const SolveCost& other) {
    gmres_iterations += other.gmres_iterations;
    matvecs += other.matvecs;
    return *this;
  }
};

/// One quasi-static solution: all that velocities, fields and rheology of its instant require.
struct Solution {
  Instant instant;                             ///< that it was solved for
  Discretisation discretisation;               ///< that the density lives on, one a component
  std::shared_ptr<const LinearSystem> system;  ///< that it solves, on the same nodes
  ComplexVector density;                       ///< at all nodes, components in order, length / time
  std::vector<RigidMotion>
      motions;                  ///< of every component about its position: solved on free bodies,
                                ///< prescribed on held bodies and rigidly moving walls, else zero
  std::vector<Load> loads;      ///< of every component on the fluid, about its position
  Complex uniform_velocity;     ///< of the fluid at infinity beside the background
  GmresResult gmres;            ///< of the linear system, converged
  double velocity_scale = 0.0;  ///< largest velocity in the data, without those that carry a body
                                ///< as a whole, see carried_by(); length / time
  double error_estimate = 0.0;  ///< of motions and loads, as relative_change() measures them; not
                                ///< a number where none was asked for
  std::vector<Gap> gaps;        ///< close pairs in ascending order, the closest pair first
  SolveCost cost;               ///< in counts
};

/// What is known of a solution with the forces of contact.
struct LoadedCheck {
  ErrorEstimate estimate;  ///< of its motions and loads
  Resolutions needed;      ///< the solution's own where they do
  double
      gmres_tolerance;  ///< that the solution was solved to, or less where nodes do and it does not
};

/// Solves a scene for any configuration of its components.
///
/// Scene -> geometry -> plan -> resolution -> operator -> velocities. Discretised shapes are
/// shared between solves; everything else is made anew for a configuration, and depends on it alone.
/// @par Accuracy  scene.solver.tolerance by estimate_error(), @ref claim_12_3, or the solve refuses
class SuspensionSolver {
 public:
  /// Plans a scene and discretises its shapes.
  ///
  /// @param  scene  to be solved
  /// @throws std::invalid_argument when a number of nodes is odd or < 4
  /// @throws SolverError when shapes with automatic nodes ask for more than "auto" takes, and by
  ///                separation_error()
  /// @par Cost      that of DiscretisationCache::get() a distinct shape, node count and kind
  explicit SuspensionSolver(const Scene& scene);

  /// Returns the instant at which the scene starts.
  /// @return the scene's poses, bodies first, then walls; amplitude 1
  Instant start() const;

  /// Returns how far contact keeps components apart.
  /// @return least gap, length; 0 in scenes without contact
  double separation() const;

  /// Solves for the motions of free bodies and the loads on all others, and estimates their error.
  ///
  /// Components with automatic nodes get those that shapes and gaps ask for, and more while the
  /// estimate exceeds the tolerance. Where the nodes do and GMRES does not, it goes on.
  /// @param  instant  poses and flow amplitude
  /// @param  guess    of the density, where GMRES begins
  /// @param  least    resolutions that automatic nodes do not fall below; empty: none
  /// @return          density, motions and loads of all components, and the error estimate
  /// @throws ConfigurationError on overlap, hopeless shapes and gaps, and an estimate above the
  ///                tolerance that no node count within the limits of node_choice.hpp brings down
  /// @throws SolverError on net flux, net force without gauge, a gauge length not
  ///                large against held components, a preconditioner that is singular, no
  ///                convergence, and numbers that are not finite
  /// @par Cost      find_gaps(), one application of SuspensionOperator and preconditioner an
  ///                iteration of GMRES, and estimate_error(); several times where nodes are raised
  Solution solve(const Instant& instant, const DensityGuess& guess = {},
                 const Resolutions& least = {}) const;

  /// Estimates the error of a solution to which the forces of contact were added.
  ///
  /// @param  loaded           solution whose density and loads include them
  /// @param  gmres_tolerance  that they were solved to
  /// @return                  the estimate, and with what to solve again where it exceeds the
  ///                          tolerance: the same where that would not help
  /// @par Cost      that of discretise() and of estimate_error()
  LoadedCheck check_loaded(const Solution& loaded, double gmres_tolerance) const;

  /// Solves a configuration near one that was solved before, without an estimate: for the stages
  /// of a time step, and for steps between those that estimate their error.
  ///
  /// @param  instant  poses and flow amplitude
  /// @param  earlier  resolution that has done, and will unless gaps have closed
  /// @param  guess    as in solve()
  /// @return          density, motions and loads of all components
  /// @throws SolverError as solve() does, but for estimates
  /// @par Cost      find_gaps(), and one application of SuspensionOperator and preconditioner an
  ///                iteration of GMRES
  Solution solve_nearby(const Instant& instant, const Resolutions& earlier,
                        const DensityGuess& guess = {}) const;

  /// Solves every component alone in the flow that all others had before: the lagged, "locally
  /// implicit" coupling, one sweep of block Jacobi,
  /// \f$ \eta = \eta' + M^{-1}(b - A\eta') \f$ with the block diagonal M of A.
  ///
  /// The error of the sweep is part of the estimate, which refuses nothing; the residual is that of
  /// the density before.
  /// @param  instant  poses and flow amplitude
  /// @param  guess    of the density before, not empty
  /// @return          density, motions and loads of all components, and the error estimate
  /// @throws SolverError as solve() does, but for estimates and convergence
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
  /// @par Not for   points near the boundary where solver.near_singular is off, nor inside bodies
  ComplexVector velocity(const Solution& solution, const ComplexVector& points) const;

  /// Prepares a solution for the evaluation of stresses and powers, without the background flow.
  ///
  /// @param  solution  of any instant
  /// @return           the disturbance, near the boundary by the Cauchy scheme whatever
  ///                   solver.near_singular says
  SolvedFlow disturbance(const Solution& solution) const;

  /// Solves for the loads of a solution on a quarter more nodes, to a hundredth of the residual.
  ///
  /// A quantity without an error estimate of its own, such as a traction, can be computed from both
  /// solutions: twice the difference estimates the error in the given one.
  /// @param  solution  with forces of contact or none
  /// @return           the same, without an estimate
  /// @throws SolverError when GMRES does not converge, or there are too many nodes
  /// @par Cost      that of a solve with a good guess
  Solution refined(const Solution& solution) const;

  /// Evaluates pressure over viscosity, vorticity and strain in a solution, the background's
  /// included.
  ///
  /// The pressure is zero at infinity; in an enclosed fluid it has a datum that means nothing.
  /// @param  solution  of any instant
  /// @param  points    m points in the fluid, or nodes of its boundary, length
  /// @return           m values, 1 / time
  /// @par Cost      m n kernel evaluations for n nodes in all
  /// @par Not for   points inside bodies
  std::vector<FlowDerivatives> derivatives(const Solution& solution,
                                           const ComplexVector& points) const;

  /// Poses the boundary value problem of an instant at a resolution.
  ///
  /// @param  instant         poses and flow amplitude
  /// @param  discretisation  of each component, such as a solution's
  /// @return                 bodies, then walls, with their nodes, loads and velocities
  StokesProblem problem(const Instant& instant, const Discretisation& discretisation) const;

  /// Builds the linear system of an instant at a resolution.
  ///
  /// @param  instant         poses and flow amplitude
  /// @param  discretisation  of each component
  /// @return                 problem, operator, and the preconditioner of the plan
  /// @throws SolverError when the preconditioner is singular, as the block of a held component
  ///                is whose size is at the degenerate scale of flow.gauge_length
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
                                     const std::vector<Gap>& gaps) const;

  /// Chooses the resolution with which solve() begins.
  ///
  /// @param  configuration  where the components are
  /// @param  gaps           in it, as gaps() finds them
  /// @return                given node counts as they are; automatic ones from shapes and gaps
  Resolutions first_resolutions(const Configuration& configuration,
                                const std::vector<Gap>& gaps) const;

  /// Finds the gaps of a configuration that may require nodes, overlaps included.
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
  /// @return what the scene needs, and why
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
    int suspicions = 0;  // how often nodes were raised although tails say that they do
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
  Complex frame_velocity(double amplitude) const;
  StokesProblem loaded_problem(const Solution& solution,
                               const Discretisation& discretisation) const;
  Effort greater(const Effort& effort, const std::vector<TailEstimate>& tails, double error) const;
  LinearSystem unpreconditioned(const StokesProblem& problem, const Configuration& configuration,
                                const Discretisation& discretisation) const;
  LinearSystem preconditioned(const StokesProblem& problem, const Configuration& configuration,
                              const std::vector<Gap>& gaps,
                              const Discretisation& discretisation) const;
  std::vector<PlacedCurve> near_curves(const Configuration& configuration,
                                       const Discretisation& discretisation) const;
  System system(const Instant& instant, const std::vector<Gap>& gaps,
                const Resolutions& resolutions) const;
  std::vector<Gap> open_gaps(const Configuration& configuration) const;
  Solution converged(const System& system, double gmres_tolerance,
                     const ComplexVector& guess) const;
  Solution completed(const System& system, GmresResult gmres) const;
  std::vector<PlacedCurve> placed(const Configuration& configuration,
                                  const Discretisation& discretisation) const;

  Scene scene_;
  Plan plan_;
  std::shared_ptr<DiscretisationCache>
      cache_;  // shared by copies; solve() is const, and may fill it
  Discretisation discretisation_;
  Resolutions least_;  // that resolve the softest mode of each component, for estimates
};

/// @}

}  // namespace stokesbook
