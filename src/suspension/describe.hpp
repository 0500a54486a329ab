#pragma once

#include <string>
#include <vector>

#include "suspension/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Names a shape with its sizes: "ellipse 1 x 0.5".
std::string shape_name(const Shape& shape);

/// Describes what a scene needs, what is left out and why, one decision a line, with what the
/// initial configuration asks of its nodes.
std::vector<std::string> describe(const SuspensionSolver& solver);

/// @}

}  // namespace stokesbook
