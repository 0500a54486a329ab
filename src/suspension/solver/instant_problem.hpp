#pragma once

#include <memory>

#include "scene/scene.hpp"
#include "suspension/solver/solution.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Returns the velocity of the frame in which an enclosed problem is solved: that of a container
/// which translates as a whole.
///
/// @param  scene      with or without such a wall
/// @param  amplitude  of the imposed flow
/// @return            length / time; 0 in all other scenes
Complex frame_velocity(const Scene& scene, double amplitude);

/// Poses the boundary value problem of an instant.
///
/// Data of free bodies in an unbounded fluid are strain_on(), those of all other components the
/// velocities relative to frame_velocity(): the solver solves for a disturbance that does not
/// depend on how fast the flow or the container carries all bodies.
/// @param  scene           with viscosity, flow, motions and loads
/// @param  instant         poses and flow amplitude
/// @param  discretisation  of each component
/// @return                 bodies, then walls, with their nodes, loads and velocities
StokesProblem instant_problem(const Scene& scene, const Instant& instant,
                              const Discretisation& discretisation);

/// Poses the problem of a solution's instant in which free bodies bear the loads of the solution:
/// those of the scene, and those of contact if there is any.
///
/// @param  scene           that was solved
/// @param  solution        with its loads
/// @param  discretisation  of each component, not necessarily that of the solution
/// @return                 as instant_problem()
StokesProblem loaded_problem(const Scene& scene, const Solution& solution,
                             const Discretisation& discretisation);

/// Completes a density to a solution: motions of free bodies and loads of all other components, by
/// the functionals of chapter 03.
///
/// @param  scene           that is solved
/// @param  instant         poses and flow amplitude
/// @param  discretisation  of each component
/// @param  system          linear system of the instant
/// @param  gmres           its solution
/// @return                 the solution without velocity scale, estimate, gaps and cost
Solution complete_solution(const Scene& scene, const Instant& instant,
                           const Discretisation& discretisation,
                           std::shared_ptr<const LinearSystem> system, GmresResult gmres);

/// @}

}  // namespace stokesbook
