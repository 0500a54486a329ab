#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace stokesbook {

/// Returns the time that a piece of work takes, in seconds.
template <class Work>
double seconds_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Returns the least time that a piece of work takes, in seconds. The least time is taken because
/// other processes only add to the time.
///
/// @param  work    called repeatedly
/// @param  budget  seconds to spend; at least two calls are made
template <class Work>
double least_seconds(const Work& work, double budget) {
  double least = std::numeric_limits<double>::infinity(), spent = 0.0;
  for (int calls = 0; calls < 2 || spent < budget; ++calls) {
    const double seconds = seconds_of(work);
    least = std::min(least, seconds);
    spent += seconds;
  }
  return least;
}

}  // namespace stokesbook
