// Runs two parallel loops. The first loop adds to a number without a lock if the program has an
// argument; the thread sanitizer must report these additions. The second loop reads results of the
// first loop after a barrier; the thread sanitizer must accept this.
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
    if (i % 2 == 1) values[i] += values[i - 1];  // another thread may have written values[i - 1]
  }
  std::printf("%g %g\n", sum, values.back());
  return 0;
}
