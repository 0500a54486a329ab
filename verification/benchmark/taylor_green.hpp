#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times set-up, matrix-vector product and solve, with all threads, for the start of the published
/// simulation of 48 slender ellipses in a Taylor-Green flow.
///
/// @param  budget  seconds to spend on each number
Table time_taylor_green(double budget);

/// Solves the same scene repeatedly, with 32 nodes for each body and without a preconditioner.
///
/// @param  solves  number of solves
void solve_taylor_green(int solves);

}  // namespace stokesbook
