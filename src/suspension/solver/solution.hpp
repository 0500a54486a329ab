#pragma once

#include <memory>
#include <vector>

#include "closure/closure.hpp"
#include "krylov/gmres.hpp"
#include "scene/scene.hpp"
#include "suspension/bodies/forcing.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/linear_system.hpp"

namespace stokesbook {

/// The work for a solution, including attempts with fewer nodes.
struct SolveCost {
  int gmres_iterations = 0;  ///< GMRES iterations of all solves for motions and loads
  int matvecs = 0;           ///< applications of the operator, including those of error estimates

  /// Adds the work of another solve.
  SolveCost& operator+=(const SolveCost& other) {
    gmres_iterations += other.gmres_iterations;
    matvecs += other.matvecs;
    return *this;
  }
};

/// One quasi-static solution: all that velocities, fields and rheology of its instant require.
struct Solution {
  Instant instant;                               ///< poses and forcing
  Discretisation discretisation;                 ///< nodes of the density
  std::shared_ptr<const LinearSystem> system{};  ///< on these nodes; none if it was dropped
  SharedTree tree{};        ///< of the system; stages of a step that begins here share it
  ComplexVector density{};  ///< at all nodes, components in order, length / time
  /// Motions of every component about its position in the instant: solved on free bodies,
  /// prescribed for held bodies and rigid walls, else zero.
  std::vector<RigidMotion> motions{};
  std::vector<Load> loads{};  ///< loads of every component on the fluid, about its position
  /// Uniform velocity of the fluid at infinity, or mean velocity over a periodic cell, beside the
  /// background.
  Complex uniform_velocity{};
  GmresResult gmres{};          ///< result of GMRES, converged
  double velocity_scale = 0.0;  ///< largest velocity in the data of the problem, which exclude
                                ///< background_rigid_motion(); length / time
  /// Error of motions and loads, as relative_change() measures them; NaN if it was not estimated.
  double error_estimate = 0.0;
  std::vector<Gap> gaps{};  ///< close pairs in ascending order, the closest pair first
  SolveCost cost{};         ///< work for this solution
};

/// Returns the motions of all components on their paths: in a periodic cell, those of a component
/// differ from those of its image in the cell.
std::vector<RigidMotion> path_motions(const Solution& solution);

/// Returns the velocity of the frame in which an enclosed problem is solved: that of a container
/// which translates as a whole; 0 in all other scenes.
Complex frame_velocity(const Scene& scene, const Forcing& forcing);

/// Poses the boundary value problem of an instant: bodies, then walls, with their nodes, loads and
/// velocities.
///
/// Data of free bodies in an unbounded fluid are straining_velocity(), those of all other
/// components the velocities relative to frame_velocity(): the solver solves for a disturbance that
/// does not depend on how fast the flow or the container carries all bodies.
/// @throws std::invalid_argument when the forcing of the instant is not that of this scene
StokesProblem instant_problem(const Scene& scene, const Instant& instant,
                              const Discretisation& discretisation);

/// Poses the problem of a solution's instant, on a discretisation of its own, in which free bodies
/// bear the loads of the solution: those of the scene, and those of contact if there is any.
StokesProblem loaded_problem(const Scene& scene, const Solution& solution,
                             const Discretisation& discretisation);

/// Completes a solution that has an instant, a discretisation and a system by the solution `gmres`
/// of this system, and by the motions and loads that follow from it (chapter 03).
Solution complete_solution(const Scene& scene, Solution solution, GmresResult gmres);

}  // namespace stokesbook
