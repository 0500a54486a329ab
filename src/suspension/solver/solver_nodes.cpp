// How many nodes components get, and what is prepared for them.
#include <algorithm>
#include <map>

#include "suspension/bodies/components.hpp"
#include "suspension/nodes/density_decay.hpp"
#include "suspension/nodes/graded_nodes.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

std::vector<int> SuspensionSolver::recommended_nodes(const Configuration& configuration,
                                                     const std::vector<Gap>& gaps) const {
  const double tolerance = scene_.solver.tolerance;
  std::map<const DiscretisedShape*, int> shape_nodes;
  std::vector<int> nodes;
  for (const auto& discretised : discretisation_) {
    const auto [entry, is_new] = shape_nodes.try_emplace(discretised.get());
    if (is_new) {
      entry->second = nodes_for_shape(discretised->shape, discretised->curve.side, tolerance, 16);
    }
    nodes.push_back(entry->second);
  }
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, discretisation_).decay;
    nodes[gap.a] = std::max(nodes[gap.a], stokesbook::recommended_nodes(decay.a, tolerance));
    nodes[gap.b] = std::max(nodes[gap.b], stokesbook::recommended_nodes(decay.b, tolerance));
  }
  return nodes;
}

Resolutions SuspensionSolver::first_resolutions(const Configuration& configuration,
                                                const std::vector<Gap>& gaps) const {
  Resolutions resolutions = resolutions_of(discretisation_);
  std::vector<std::vector<GapDemand>> demands(resolutions.size());
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, discretisation_).decay;
    demands[gap.a].push_back({gap.points.parameter_a, decay.a});
    demands[gap.b].push_back({gap.points.parameter_b, decay.b});
  }
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    if (!component_of(scene_, k).has_automatic_nodes() || demands[k].empty()) continue;
    const int own = resolutions[k].n_nodes;
    resolutions[k] = nodes_for_gaps(demands[k], own, scene_.solver.tolerance);
    if (resolutions[k].n_nodes > own) {
      resolutions[k].n_nodes = rounded_nodes(resolutions[k].n_nodes);
    }
  }
  return resolutions;
}

Discretisation SuspensionSolver::discretise(const Resolutions& resolutions) const {
  Discretisation discretisation;
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    const ComponentView component = component_of(scene_, k);
    discretisation.push_back(cache_->get(component.shape, resolutions[k], component.kind));
  }
  return discretisation;
}

}  // namespace stokesbook
