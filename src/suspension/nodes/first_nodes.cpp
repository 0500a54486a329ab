// Chooses the node numbers with which a solve begins: those that the shapes require, and those that
// the decay of densities near the gaps requires (chapter 12, section "How fine").
#include "suspension/nodes/first_nodes.hpp"

#include <algorithm>
#include <map>

#include "suspension/bodies/components.hpp"
#include "suspension/nodes/density_decay.hpp"
#include "suspension/nodes/graded_nodes.hpp"
#include "suspension/nodes/node_choice.hpp"

namespace stokesbook {

std::vector<int> recommended_nodes(const Discretisation& discretisation, double tolerance,
                                   const Configuration& configuration,
                                   const std::vector<Gap>& gaps) {
  std::map<const DiscretisedShape*, int> shape_nodes;
  std::vector<int> nodes;
  for (const auto& discretised : discretisation) {
    const auto [entry, is_new] = shape_nodes.try_emplace(discretised.get());
    if (is_new) {
      entry->second = nodes_for_shape(discretised->shape, discretised->curve.side, tolerance, 16);
    }
    nodes.push_back(entry->second);
  }
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, discretisation).decay;
    nodes[gap.a] = std::max(nodes[gap.a], recommended_nodes(decay.a, tolerance));
    nodes[gap.b] = std::max(nodes[gap.b], recommended_nodes(decay.b, tolerance));
  }
  return nodes;
}

Resolutions first_resolutions(const Scene& scene, const Discretisation& discretisation,
                              const Configuration& configuration, const std::vector<Gap>& gaps) {
  Resolutions resolutions = resolutions_of(discretisation);
  std::vector<std::vector<GapRequirement>> demands(resolutions.size());
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, discretisation).decay;
    demands[gap.a].push_back({gap.points.parameter_a, decay.a});
    demands[gap.b].push_back({gap.points.parameter_b, decay.b});
  }
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    if (!component_of(scene, k).has_automatic_nodes() || demands[k].empty()) continue;
    const int own = resolutions[k].n_nodes;
    resolutions[k] = nodes_for_gaps(demands[k], own, scene.solver.tolerance);
    if (resolutions[k].n_nodes > own) {
      resolutions[k].n_nodes = rounded_nodes(resolutions[k].n_nodes);
    }
  }
  return resolutions;
}

}  // namespace stokesbook
