// Finds all contacts of a step: broad phase by rectangles, then for each pair the narrow phase and
// connected contacts (chapter 10).
#include "stiv/interferences.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

namespace stokesbook {

namespace {

// Contacts that end within this many separations are listed even if no gap is violated.
constexpr double watched_separations = 4.0;

void require_valid(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                   const ContactRules& rules) {
  if (shapes.size() != paths.size()) {
    throw std::invalid_argument("contact requires a path for each shape, got " +
                                std::to_string(shapes.size()) + " shapes and " +
                                std::to_string(paths.size()) + " paths");
  }
  const auto require_positive = [](double value, const std::string& what) {
    if (value > 0.0) return;
    throw std::invalid_argument("contact requires a positive " + what + ", got " +
                                std::to_string(value));
  };
  require_positive(rules.separation.everywhere, "separation");
  for (const auto& [pair, own] : rules.separation.closer) {
    require_positive(own, "separation of components " + std::to_string(pair.first) + " and " +
                              std::to_string(pair.second));
  }
  require_positive(rules.tolerance, "tolerance");
  if (!(rules.dip >= 0.0 && rules.dip <= 1.0)) {
    throw std::invalid_argument("contact requires a dip from 0 to 1, got " +
                                std::to_string(rules.dip));
  }
}

// Finds the contacts of one pair of components: narrow phase, then grouping.
Interferences in_pair(const ContactShapes& shapes, const PathPair& paths,
                      const ContactRules& rules) {
  const double separation = rules.separation.between(paths.a, paths.b);
  const PairEvents events = pair_events(
      shapes, paths, {separation, rules.tolerance, watched_separations * separation, rules.dip});
  SearchCost cost = events.cost;
  cost.pairs = 1;
  return {connected_contacts(events, rules.tolerance, rules.rows), cost};
}

}  // namespace

bool Interferences::admits_step() const {
  return std::ranges::none_of(contacts, &Contact::is_violated);
}

Interferences interferences(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                            const ContactRules& rules) {
  require_valid(shapes, paths, rules);
  std::vector<Rectangle> swept;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    swept.push_back(swept_rectangle(*shapes[k], paths[k]));
  }
  const std::vector<ComponentPair> pairs =
      near_pairs(shapes, swept, watched_separations * rules.separation.everywhere);
  std::vector<Interferences> of_pairs(pairs.size());
  const auto pair_count = static_cast<std::ptrdiff_t>(pairs.size());
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t i = 0; i < pair_count; ++i) {
    const auto [a, b] = pairs[static_cast<std::size_t>(i)];
    of_pairs[static_cast<std::size_t>(i)] = in_pair(shapes, {a, b, paths[a], paths[b]}, rules);
  }
  Interferences all;
  for (Interferences& found : of_pairs) {
    std::ranges::move(found.contacts, std::back_inserter(all.contacts));
    all.cost += found.cost;
  }
  return all;
}

}  // namespace stokesbook
