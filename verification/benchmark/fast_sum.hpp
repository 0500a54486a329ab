#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times the fast multipole sum of ellipses relative to the direct sum, for several tolerances. The
/// plan, an application, and the application to several fields at once are timed with one thread,
/// and an application also with two threads.
///
/// @param  bodies  number of ellipses of 128 nodes
/// @param  budget  seconds to spend on each number
Table time_fast_sum(int bodies, double budget);

/// Times both sums over few nodes with one thread, and finds the number of nodes beyond which the
/// fast sum is faster.
///
/// @param  budget  seconds to spend on each number
Table time_break_even(double budget);

}  // namespace stokesbook
