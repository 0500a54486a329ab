// Runs two parallel loops: the first adds to a number without a lock on request, the second reads
// results of the first after a barrier. The thread sanitizer must report the former and accept the
// latter.
#include <cstdio>
#include <vector>

int main(int argc, char**) {
  const bool race = argc > 1;
  std::vector<double> values(64, 0.0);
  double sum = 0.0;
#pragma omp parallel for
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<double>(i);
    if (race) sum += values[i];
  }
#pragma omp parallel for
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (i % 2 == 1) values[i] += values[i - 1];  // perhaps of another thread
  }
  std::printf("%g %g\n", sum, values.back());
  return 0;
}
