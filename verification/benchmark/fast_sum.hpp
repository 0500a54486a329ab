#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times the fast multipole sum of ellipses beside the direct one, by the tolerance, one thread:
/// plan, application, several fields at once; and an application with two threads.
///
/// @param  bodies  number of ellipses of 128 nodes
/// @param  budget  seconds to spend on each number
Table time_fast_sum(int bodies, double budget);

/// Times both sums of few nodes, one thread, and finds from where on the fast one is faster.
///
/// @param  budget  seconds to spend on each number
Table time_break_even(double budget);

}  // namespace stokesbook
