// Counts nodes, adds up forces and finds which kinds of components a problem has.
#include "closure/problem.hpp"

#include <algorithm>
#include <cmath>

namespace stokesbook {

using Eigen::Index;

std::vector<Index> node_offsets(const StokesProblem& problem) {
  std::vector<Index> offsets{0};
  for (const Component& component : problem.components) {
    offsets.push_back(offsets.back() + component.curve.size());
  }
  return offsets;
}

std::vector<Curve> curves_of(const StokesProblem& problem) {
  std::vector<Curve> curves;
  for (const Component& component : problem.components) curves.push_back(component.curve);
  return curves;
}

bool is_bounded(const StokesProblem& problem) {
  return !std::ranges::all_of(problem.components, is_inner);
}

Complex total_given_force(const StokesProblem& problem) {
  Complex total{};
  for (const Component& component : problem.components) {
    if (component.kind == ComponentKind::free_body) total += component.force;
  }
  return total;
}

bool has_net_force(const StokesProblem& problem) {
  double scale = 0.0;
  for (const Component& component : problem.components) scale += std::abs(component.force);
  return std::abs(total_given_force(problem)) > 1e-12 * scale;
}

bool has_free_uniform_velocity(const StokesProblem& problem) {
  if (problem.cell) return problem.cell->pressure_gradient.has_value();
  return !is_bounded(problem) && !problem.gauge_length &&
         std::ranges::count(problem.components, ComponentKind::prescribed, &Component::kind) > 0;
}

}  // namespace stokesbook
