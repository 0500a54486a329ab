#pragma once

#include "closure/problem.hpp"
#include "krylov/gmres.hpp"
#include "suspension/system/operator.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The linear system of one configuration at one resolution.
struct LinearSystem {
  StokesProblem problem;        ///< components with their nodes and data
  SuspensionOperator system;    ///< density in, velocity at the nodes out
  LinearMap precondition = {};  ///< interleaved, as GMRES takes it; empty: none
  bool is_factorised = false;   ///< the preconditioner solves, but for its near corrections' errors
};

/// Solves a system by GMRES.
///
/// @param  discrete  the system, n nodes in all
/// @param  rhs       velocities at all n nodes, length / time
/// @param  options   when to stop
/// @param  guess     density at all n nodes to begin with; empty: none
/// @return           solution and history, interleaved
/// @throws SolverError when gmres() breaks down, or meets numbers that are not finite
/// @par Cost         that of gmres()
GmresResult solve(const LinearSystem& discrete, const ComplexVector& rhs,
                  const GmresOptions& options, const ComplexVector& guess = {});

/// @}

}  // namespace stokesbook
