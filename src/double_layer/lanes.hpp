#pragma once

#include <cstring>

namespace stokesbook {

/// @addtogroup double_layer
/// @{

// Source files that are compiled for different processors differ in the width of a register.
// Functions of the libraries therefore pass plain arrays to each other, and use Lanes inside only.
#if defined(__AVX512F__)
/// Number of doubles in a register of this processor.
inline constexpr int lane_count = 8;
#elif defined(__AVX__)
/// Number of doubles in a register of this processor.
inline constexpr int lane_count = 4;
#else
/// Number of doubles in a register of this processor.
inline constexpr int lane_count = 2;
#endif

/// The doubles of one register, by the vector extension of GCC and Clang.
using Lanes = double __attribute__((vector_size(8 * lane_count)));

/// Loads a register from memory.
///
/// @param  from  lane_count numbers
/// @return       the same numbers in a register
inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

/// Stores a register in memory.
///
/// @param  lanes  lane_count numbers
/// @param  to     memory for lane_count numbers
inline void store(const Lanes& lanes, double* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

/// @}

}  // namespace stokesbook
