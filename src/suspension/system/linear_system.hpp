#pragma once

#include <vector>

#include "closure/problem.hpp"
#include "krylov/gmres.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/operator.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The linear system of one instant at one resolution.
struct LinearSystem {
  StokesProblem problem;        ///< components with their nodes and data
  SuspensionOperator system;    ///< density in, velocity at the nodes out
  LinearMap precondition = {};  ///< approximate inverse, interleaved; empty: none
  bool is_factorised = false;   ///< whether the preconditioner solves the system, up to the
                                ///< errors of its near corrections
};

/// Solves a system by GMRES.
///
/// @param  discrete  the system, n nodes in all
/// @param  rhs       velocities at all n nodes, length / time
/// @param  options   when to stop
/// @param  guess     density with which GMRES begins, at all n nodes; empty: zero
/// @return           solution and history, interleaved
/// @throws SolverError when gmres() breaks down, or meets numbers that are not finite
/// @par Cost         that of gmres()
GmresResult solve(const LinearSystem& discrete, const ComplexVector& rhs,
                  const GmresOptions& options, const ComplexVector& guess = {});

/// Builds the linear system of a problem without a preconditioner.
///
/// @param  plan            of the scene
/// @param  problem         of an instant
/// @param  configuration   where the components are
/// @param  discretisation  of each component
/// @return                 problem and operator
LinearSystem unpreconditioned_system(const Plan& plan, const StokesProblem& problem,
                                     const Configuration& configuration,
                                     const Discretisation& discretisation);

/// Builds the linear system of a problem with the preconditioner that plan and gaps require.
///
/// @param  scene           scene whose components are named in messages
/// @param  plan            of the scene
/// @param  problem         of an instant
/// @param  configuration   where the components are
/// @param  gaps            of the configuration, as find_gaps() returns them
/// @param  discretisation  of each component
/// @param  separation      least gap that contact maintains, length; 0: no contact
/// @return                 problem, operator and preconditioner
/// @throws SolverError when the preconditioner is singular, as the block of a held component is
///                whose size is at the degenerate scale of flow.gauge_length
LinearSystem preconditioned_system(const Scene& scene, const Plan& plan,
                                   const StokesProblem& problem, const Configuration& configuration,
                                   const std::vector<Gap>& gaps,
                                   const Discretisation& discretisation, double separation);

/// @}

}  // namespace stokesbook
