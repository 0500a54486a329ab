#pragma once

#include <string>
#include <vector>

#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Names a shape with its sizes.
///
/// @param  shape  any shape
/// @return        text such as "ellipse 1 x 0.5"
std::string shape_name(const Shape& shape);

/// Describes the decisions of a plan with their reasons, the time steps, and the nodes and gaps of
/// the initial configuration.
///
/// @param  solver  of the scene
/// @return         lines of text
/// @par Cost       that of SuspensionSolver::recommended_nodes(); no system is solved
std::vector<std::string> describe(const SuspensionSolver& solver);

/// Describes how well a solution is resolved.
///
/// @param  solver    of the scene
/// @param  solution  at the start
/// @return           a line with error estimate, tolerance, nodes and GMRES iterations
std::string describe(const SuspensionSolver& solver, const Solution& solution);

/// @}

}  // namespace stokesbook
