#pragma once

namespace stokesbook {

/// Measures the floating-point operations per second of one core in independent chains of fused
/// multiply-adds (two operations each) on the widest vectors of this build. No other loop is
/// faster.
///
/// @param  budget  seconds to spend
double fma_peak(double budget);

}  // namespace stokesbook
