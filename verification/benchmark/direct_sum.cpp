// Times the direct stresslet sum, streamed and stored, relative to the processor's peak.
#include "direct_sum.hpp"

#include <omp.h>

#include "double_layer/stresslet_sum.hpp"
#include "stopwatch.hpp"

namespace stokesbook {

namespace {

// Returns a row of ellipses with 32 nodes each, n nodes in all.
std::vector<Curve> row_of_ellipses(int n) {
  const Curve ellipse = sample(Ellipse{1.0, 0.5}, 32, Side::fluid_outside);
  std::vector<Curve> curves;
  for (int k = 0; k < n / 32; ++k) curves.push_back(place(ellipse, 3.0 * k, 0.1 * k));
  return curves;
}

double seconds_per_application(const StressletSum& sum, int threads, double budget) {
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(threads);
  const ComplexVector density = ComplexVector::Ones(sum.size());
  const double seconds = least_seconds([&] { return sum(density); }, budget);
  omp_set_num_threads(threads_before);
  return seconds;
}

}  // namespace

Table time_direct_sum(double peak, int most, double budget) {
  Table table{
      "Direct stresslet sum, streamed",
      {"nodes", "ms", "Gpairs/s", "% of peak", "two threads"},
      {},
      "  % of peak: 19 operations a pair, as 2 (r) + 3 (rho^2) + 3 (r.n) + 3 (r.eta) +\n"
      "  3 (product, 1/rho^4 with one division) + 1 (factor) + 4 (accumulate), one thread;\n"
      "  two threads: their speed over that of one thread",
      "% of the peak of one core",
      3,
      3};
  for (int n = 128; n <= most; n *= 2) {
    const StressletSum sum(row_of_ellipses(n));
    const double one = seconds_per_application(sum, 1, budget);
    const double two = seconds_per_application(sum, 2, budget);
    const double pairs_per_second = static_cast<double>(n) * n / one;
    table.rows.push_back({static_cast<double>(n), 1e3 * one, 1e-9 * pairs_per_second,
                          100.0 * operations_per_pair * pairs_per_second / peak, one / two});
  }
  return table;
}

Table time_storage(double budget) {
  Table table{"Stored matrix beside streamed sum, one thread",
              {"nodes", "streamed ms", "stored ms", "stored/streamed"},
              {},
              "",
              "ms an application",
              1,
              2};
  int break_even = 0;
  for (int n : {32, 64, 96, 128, 160, 192, 256, 320, 384, 512, 768, 1024}) {
    const std::vector<Curve> curves = row_of_ellipses(n);
    const double streamed = seconds_per_application(StressletSum(curves), 1, budget);
    const StressletSum stored_sum(curves, KernelStorage::stored);
    const double stored = seconds_per_application(stored_sum, 1, budget);
    if (stored < streamed) break_even = n;
    table.rows.push_back({static_cast<double>(n), 1e3 * streamed, 1e3 * stored, stored / streamed});
  }
  int chosen = 0;
  while (StressletSum::automatic_storage(chosen + 1) == KernelStorage::stored) ++chosen;
  table.note = "  the stored matrix is faster up to " + std::to_string(break_even) +
               " nodes here; the plan stores up to " + std::to_string(chosen);
  return table;
}

}  // namespace stokesbook
