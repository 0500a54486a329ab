#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times set-up, matrix-vector product and solve for 48 slender ellipses in a Taylor-Green flow,
/// where their published simulation starts, with all threads.
///
/// @param  budget  seconds to spend on each number
Table time_taylor_green(double budget);

/// Solves the same scene again and again, with 32 nodes a body and no preconditioner.
///
/// @param  solves  how often
void solve_taylor_green(int solves);

}  // namespace stokesbook
