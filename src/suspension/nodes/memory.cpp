// Estimates the memory of the matrices of all shapes, and explains that they do not fit, before any
// matrix is allocated.
#include "suspension/nodes/memory.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

#include "suspension/bodies/components.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

// Components with fewer nodes are not counted: their matrices are small, and the search for other
// components of the same shape would not pay.
constexpr int few_nodes = 128;

std::string gigabytes(double bytes) {
  return short_number(bytes / 1e9) + " GB";
}

}  // namespace

double available_memory() {
  const double machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::min(machine, static_cast<double>(limit.rlim_cur)) : machine;
}

std::string memory_error(const Scene& scene, const Resolutions& resolutions, double available) {
  std::map<int, std::vector<std::size_t>> distinct;  // components by node number, one per shape
  double bytes = 0.0;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    const int nodes = resolutions[k].n_nodes;
    if (nodes > resolutions[largest].n_nodes) largest = k;
    if (nodes < few_nodes) continue;
    std::vector<std::size_t>& others = distinct[nodes];
    if (std::ranges::any_of(others, [&](std::size_t other) {
          return component_of(scene, other).shape == component_of(scene, k).shape;
        })) {
      continue;
    }
    others.push_back(k);
    bytes += memory_of_discretised_shape(nodes);
  }
  if (bytes <= available) return {};
  const int most = resolutions[largest].n_nodes;
  return component_of(scene, largest).name() + " has " + std::to_string(most) +
         " nodes, whose matrices take " + gigabytes(memory_of_discretised_shape(most)) +
         ", and those of all shapes " + gigabytes(bytes) + ", but only " + gigabytes(available) +
         " are available: reduce n_nodes, or raise solver.tolerance = " +
         short_number(scene.solver.tolerance);
}

}  // namespace stokesbook
