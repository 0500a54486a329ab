#pragma once

#include <cstring>

namespace stokesbook {

/// @addtogroup double_layer
/// @{

// Sources compiled for different processors differ in these widths: functions of the libraries pass
// plain arrays to each other, and only compute in lanes.
#if defined(__AVX512F__)
/// Numbers that this processor computes with at once.
inline constexpr int lane_count = 8;
#elif defined(__AVX__)
/// Numbers that this processor computes with at once.
inline constexpr int lane_count = 4;
#else
/// Numbers that this processor computes with at once.
inline constexpr int lane_count = 2;
#endif

/// A register full of numbers, by the vector extension of GCC and Clang.
using Lanes = double __attribute__((vector_size(8 * lane_count)));

/// Reads a register.
///
/// @param  from  lane_count numbers
/// @return       the same
inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

/// Writes a register.
///
/// @param  lanes  lane_count numbers
/// @param  to     where they go
inline void store(const Lanes& lanes, double* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

/// @}

}  // namespace stokesbook
