// Measures the peak rate of one core by independent chains of fused multiply-adds.
#include "fma_peak.hpp"

#include "stopwatch.hpp"

namespace stokesbook {

namespace {

#if defined(__AVX512F__)
constexpr int vector_bytes = 64;
#elif defined(__AVX__)
constexpr int vector_bytes = 32;
#else
constexpr int vector_bytes = 16;
#endif
typedef double Vector __attribute__((vector_size(vector_bytes)));
constexpr int lanes = vector_bytes / static_cast<int>(sizeof(double));

// Two units with a latency of four cycles require eight chains; twelve chains leave a margin and
// fit into the registers.
constexpr int chains = 12;

// The chains converge to 1 from any start.
double run_chains(double start, long long length) {
  Vector x[chains];
  for (int k = 0; k < chains; ++k) x[k] = Vector{} + start * k;
  const Vector factor = Vector{} + 0.5, summand = Vector{} + 0.5;
  for (long long i = 0; i < length; ++i) {
#pragma GCC unroll 12
    for (int k = 0; k < chains; ++k) x[k] = x[k] * factor + summand;
  }
  double sum = 0.0;
  for (const Vector& v : x) sum += v[0];
  return sum;
}

}  // namespace

double fma_peak(double budget) {
  constexpr long long length = 1'000'000;
  // The volatile store prevents the compiler from removing the work.
  volatile double result = 0.25;
  const double seconds = least_seconds([&] { result = run_chains(result, length); }, budget);
  return 2.0 * lanes * chains * static_cast<double>(length) / seconds;
}

}  // namespace stokesbook
