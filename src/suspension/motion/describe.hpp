#pragma once

#include <string>
#include <vector>

#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Names a shape with its sizes.
///
/// @param  shape  any
/// @return        "ellipse 1 x 0.5"
std::string shape_name(const Shape& shape);

/// Describes what a scene needs, what is left out and why, with what the initial configuration asks
/// of its nodes.
///
/// @param  solver  of the scene
/// @return         lines, one a decision
/// @par Cost       that of SuspensionSolver::recommended_nodes(); nothing is solved
std::vector<std::string> describe(const SuspensionSolver& solver);

/// Describes how well a solution is resolved.
///
/// @param  solver    of the scene
/// @param  solution  at the start
/// @return           a line: estimate, tolerance, nodes
std::string describe(const SuspensionSolver& solver, const Solution& solution);

/// @}

}  // namespace stokesbook
