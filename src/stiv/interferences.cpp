// Finds all contacts of a step: broad phase by rectangles, then for each pair the narrow phase and
// connected contacts (chapter 10).
#include "stiv/interferences.hpp"

#include <iterator>

#include "trapezoid/require.hpp"

namespace stokesbook {

namespace {

void require_valid(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                   const ContactRules& rules) {
  require(shapes.size() == paths.size(), "contact requires a path for each shape, got ",
          shapes.size(), " shapes and ", paths.size(), " paths");
  const auto& [everywhere, closer] = rules.separation;
  require(everywhere > 0.0, "contact requires a positive separation, got ", everywhere);
  for (const auto& [pair, own] : closer) {
    require(own > 0.0, "contact requires a positive separation of components ", pair.first, " and ",
            pair.second, ", got ", own);
  }
  require(rules.tolerance > 0.0, "contact requires a positive tolerance, got ", rules.tolerance);
  const double intrusion = rules.allowed_intrusion;
  require(intrusion >= 0.0 && intrusion <= 1.0,
          "contact requires an allowed intrusion from 0 to 1, got ", intrusion);
}

// Finds the contacts of one pair of components: narrow phase, then grouping.
Interferences find_in_pair(const ContactShapes& shapes, const PathPair& paths,
                           const ContactRules& rules) {
  const double separation = rules.separation.between(paths.a, paths.b);
  const PairEvents events = pair_events(
      shapes, paths,
      {separation, rules.tolerance, listed_separations * separation, rules.allowed_intrusion});
  SearchCost cost = events.cost;
  cost.pairs = 1;
  return {connected_contacts(events, rules.tolerance, rules.rows), cost};
}

}  // namespace

Interferences interferences(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                            const ContactRules& rules) {
  require_valid(shapes, paths, rules);
  std::vector<Rectangle> swept;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    swept.push_back(swept_rectangle(*shapes[k], paths[k]));
  }
  const std::vector<ComponentPair> pairs =
      near_pairs(shapes, swept, listed_separations * rules.separation.everywhere);
  std::vector<Interferences> of_pairs(pairs.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    of_pairs[i] = find_in_pair(shapes, {a, b, paths[a], paths[b]}, rules);
  }
  Interferences all;
  for (Interferences& found : of_pairs) {
    std::ranges::move(found.contacts, std::back_inserter(all.contacts));
    all.cost += found.cost;
  }
  return all;
}

}  // namespace stokesbook
