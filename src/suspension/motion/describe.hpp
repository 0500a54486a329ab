#pragma once

#include <string>
#include <vector>

#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Describes the decisions of a plan with their reasons, the time steps, and the nodes and gaps of
/// the initial configuration, as lines of text.
///
/// @par Cost       that of SuspensionSolver::recommended_nodes(); no system is solved
std::vector<std::string> describe(const SuspensionSolver& solver);

/// Describes how well the solution at the start is resolved, as a line with error estimate,
/// tolerance, nodes and GMRES iterations.
std::string describe(const SuspensionSolver& solver, const Solution& solution);

}  // namespace stokesbook
