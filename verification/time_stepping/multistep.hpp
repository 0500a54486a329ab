#pragma once

#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

/// Runs a motion by GSL's Adams method of variable order (`msadams`) through the times at which the
/// solution is known. The method serves for comparison only: its history can neither be saved nor
/// continue after a jump of the rate, and it has no interpolant.
RunResult run_multistep(const Motion& motion, double tolerance);

}  // namespace stokesbook::verification::time_stepping
