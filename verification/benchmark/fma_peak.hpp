#pragma once

namespace stokesbook {

/// Measures how many floating-point operations a second one core does in independent chains of
/// fused multiply-adds on the widest vectors of this build, two operations each: no loop does more.
///
/// @param  budget  seconds to spend
double fma_peak(double budget);

}  // namespace stokesbook
