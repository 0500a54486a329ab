#pragma once

#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

/// Runs through the times at which a motion is known by GSL's Adams method of variable order
/// (`msadams`), for comparison only: its history can neither be saved nor taken over a jump of the
/// rate, and it has no interpolant.
RunResult run_multistep(const Motion& motion, double tolerance);

}  // namespace stokesbook::verification::time_stepping
