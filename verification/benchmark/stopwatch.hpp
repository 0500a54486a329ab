#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace stokesbook {

/// Returns the least time that a piece of work takes, in seconds: other processes only ever add to
/// it.
///
/// @param  work    called again and again
/// @param  budget  seconds to spend; at least three calls are made
template <class Work>
double least_seconds(const Work& work, double budget) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
  double least = std::numeric_limits<double>::infinity();
  const Clock::time_point begin = Clock::now();
  for (int calls = 0; calls < 3 || seconds(Clock::now() - begin) < budget; ++calls) {
    const Clock::time_point start = Clock::now();
    work();
    least = std::min(least, seconds(Clock::now() - start));
  }
  return least;
}

}  // namespace stokesbook
