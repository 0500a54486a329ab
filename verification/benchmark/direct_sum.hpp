#pragma once

#include "table.hpp"

namespace stokesbook {

/// Number of floating-point operations for each pair of the direct stresslet sum.
inline constexpr double operations_per_pair = 19.0;

/// Times the streamed sum over all pairs of n nodes with one thread and with two.
///
/// @param  peak    operations per second of one core, see fma_peak()
/// @param  most    largest n
/// @param  budget  seconds to spend on each number
Table time_direct_sum(double peak, int most, double budget);

/// Times applications of the stored matrix and of the streamed sum with one thread, and finds the
/// number of nodes beyond which streaming is faster.
Table time_storage(double budget);

}  // namespace stokesbook
