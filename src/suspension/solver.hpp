#pragma once

#include <memory>
#include <vector>

#include "closure/closure.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_correction.hpp"
#include "scene/scene.hpp"
#include "stress/solved_flow.hpp"
#include "suspension/configuration.hpp"
#include "suspension/gaps.hpp"
#include "suspension/numerics_refused.hpp"
#include "suspension/plan.hpp"
#include "suspension/reference.hpp"
#include "suspension/resolution.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// One quasi-static solution.
struct Solution {
  ComplexVector density;  ///< at all nodes, components in order, length / time
  std::vector<RigidMotion>
      motions;                  ///< of every component about its position: solved on free bodies,
                                ///< prescribed on held bodies and rigidly moving walls, else zero
  std::vector<Load> loads;      ///< of every component on the fluid, about its position
  Complex uniform_velocity;     ///< of the fluid at infinity beside the background
  GmresResult gmres;            ///< of the linear system, converged
  double velocity_scale = 0.0;  ///< largest velocity in the data, length / time
  double error_estimate = 0.0;  ///< of velocities, relative to velocity_scale
  std::vector<Gap> gaps;        ///< close pairs in ascending order, the closest pair first
};

/// Solves a scene for any configuration of its components.
///
/// Scene -> geometry -> plan -> operator -> velocities; references are built once, everything else
/// anew a configuration.
/// @par Accuracy  scene.solver.tolerance by the estimates of resolution.hpp, or the solve refuses
class SuspensionSolver {
 public:
  /// Plans a scene without fills and prepares its references.
  ///
  /// @param  scene  without fills: with_fills_placed() comes first
  /// @throws std::invalid_argument when a number of nodes is odd or < 4
  /// @throws NumericsRefused when a component's own block is singular (gauge length at a degenerate
  ///                scale)
  /// @par Cost      that of ReferenceShelf::get() a distinct shape, node count and kind
  explicit SuspensionSolver(const Scene& scene);

  /// Returns the scene's placements at the start.
  /// @return bodies, then walls, in the scene's order
  Configuration initial_configuration() const;

  /// Solves for the motions of free bodies and the loads on all others.
  ///
  /// @param  configuration  where the components are
  /// @param  drive          +1, or -1 where the scene has reversed its flow, walls and loads
  /// @return                density, motions and loads of all components, and the error estimate
  /// @throws NumericsRefused on overlap, net flux, net force without gauge, a gauge length not
  ///                large against held components, unresolved shapes, gaps or densities, no
  ///                convergence, and numbers that are not finite
  /// @par Cost      find_gaps(), and one application of SuspensionOperator and preconditioner an
  ///                iteration of GMRES
  Solution solve(const Configuration& configuration, double drive = 1.0) const;

  /// Checks the shapes and gaps of a configuration, without solving.
  ///
  /// @param  configuration  where the components are
  /// @throws NumericsRefused on overlap, unresolved shapes and unresolved gaps
  /// @par Cost      that of find_gaps()
  void refuse_unresolved(const Configuration& configuration) const;

  /// Evaluates the fluid's velocity in a solution.
  ///
  /// @param  configuration  where the components are
  /// @param  solution       from solve() in this configuration
  /// @param  points         m points in the fluid or on its boundary, length
  /// @param  drive          as in solve()
  /// @return                m velocities, length / time
  /// @par Cost      m n kernel evaluations for n nodes in all
  /// @par Not for   points near the boundary where solver.near_singular is off, nor inside bodies
  ComplexVector velocity(const Configuration& configuration, const Solution& solution,
                         const ComplexVector& points, double drive = 1.0) const;

  /// Prepares a solution for the evaluation of stresses and powers, without the background flow.
  ///
  /// @param  configuration  where the components are
  /// @param  solution       from solve() in this configuration
  /// @param  drive          as in solve()
  /// @return                the disturbance, near the boundary by the Cauchy scheme whatever
  ///                        solver.near_singular says
  SolvedFlow disturbance(const Configuration& configuration, const Solution& solution,
                         double drive = 1.0) const;

  /// Evaluates pressure over viscosity, vorticity and strain in a solution, the background's
  /// included.
  ///
  /// The pressure is zero at infinity; in an enclosed fluid it has a datum that means nothing.
  /// @param  configuration  where the components are
  /// @param  solution       from solve() in this configuration
  /// @param  points         m points in the fluid, or nodes of its boundary, length
  /// @param  drive          as in solve()
  /// @return                m values, 1 / time
  /// @par Cost      m n kernel evaluations for n nodes in all
  /// @par Not for   points inside bodies
  std::vector<FlowDerivatives> derivatives(const Configuration& configuration,
                                           const Solution& solution, const ComplexVector& points,
                                           double drive = 1.0) const;

  /// Poses the boundary value problem of a configuration.
  ///
  /// @param  configuration  where the components are
  /// @param  drive          as in solve()
  /// @return                bodies, then walls, with their nodes, loads and velocities
  StokesProblem problem(const Configuration& configuration, double drive = 1.0) const;

  /// Recommends nodes for every component, so that shapes and the gaps of a configuration meet the
  /// tolerance.
  ///
  /// @param  configuration  where the components are
  /// @return                multiples of 16, one a component; 0 where no number up to 4096 resolves
  ///                        a shape, and no gap asks for more
  /// @par Cost      that of nodes_for_shape() a component, and of find_gaps()
  std::vector<int> recommended_nodes(const Configuration& configuration) const;

  /// Returns the scene.
  /// @return the scene that was planned
  const Scene& scene() const { return scene_; }

  /// Returns the plan.
  /// @return what the scene needs, and why
  const Plan& plan() const { return plan_; }

  /// Returns the shared reference of each component.
  /// @return bodies, then walls, in the scene's order
  const References& references() const { return references_; }

 private:
  void refuse_bad_geometry(const Configuration& configuration, const std::vector<Gap>& gaps) const;
  void refuse_bad_data(const StokesProblem& problem) const;
  void estimate_error(Solution& solution, const StokesProblem& problem,
                      const ComplexVector& rest) const;
  std::vector<PlacedCurve> placed(const Configuration& configuration) const;
  BlockDiagonalPreconditioner preconditioner(const Configuration& configuration) const;

  Scene scene_;
  Plan plan_;
  References references_;
};

/// @}

}  // namespace stokesbook
