#pragma once

#include <cstring>

namespace stokesbook {

/// Number of doubles in a register of the processor for which a source file is compiled. Source
/// files may differ in this number: functions of the libraries therefore pass plain arrays to each
/// other, and use Lanes inside only.
#if defined(__AVX512F__)
inline constexpr int lane_count = 8;
#elif defined(__AVX__)
inline constexpr int lane_count = 4;
#else
inline constexpr int lane_count = 2;
#endif

/// The doubles of one register, by the vector extension of GCC and Clang.
using Lanes = double __attribute__((vector_size(8 * lane_count)));

/// Loads a register from memory.
inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

/// Stores a register in memory.
inline void store(const Lanes& lanes, double* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

}  // namespace stokesbook
