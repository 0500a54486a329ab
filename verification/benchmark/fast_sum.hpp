#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times the fast multipole sum of ellipses relative to the direct sum, by the tolerance: plan,
/// application and several fields at once with one thread; an application with two threads.
///
/// @param  bodies  number of ellipses of 128 nodes
/// @param  budget  seconds to spend on each number
Table time_fast_sum(int bodies, double budget);

/// Times both sums of few nodes with one thread, and finds the number of nodes beyond which the
/// fast sum is faster.
///
/// @param  budget  seconds to spend on each number
Table time_break_even(double budget);

}  // namespace stokesbook
