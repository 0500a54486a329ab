#include "fmm/interactions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stokesbook {

using Eigen::Index;

namespace {

using BoxPair = std::pair<Index, Index>;  // target, source

bool well_separated(const Box& target, const Box& source) {
  constexpr double rho = 0.5;
  const double distance = std::abs(target.centre - source.centre);
  // Not for two points at the same place, whose radii and distance vanish.
  return source.radius < rho * (distance - target.radius) &&
         target.radius < rho * (distance - source.radius);
}

class Traversal {
 public:
  Traversal(const Quadtree& targets, const Quadtree& sources, Index direct_pairs)
      : targets_(targets.boxes()), sources_(sources.boxes()), direct_pairs_(direct_pairs) {
    if (!targets_.empty() && !sources_.empty()) visit(0, 0);
  }

  std::vector<BoxPair> far, near;

 private:
  void visit(Index t, Index s) {
    const Box& target = targets_[static_cast<std::size_t>(t)];
    const Box& source = sources_[static_cast<std::size_t>(s)];
    if (well_separated(target, source)) {
      const bool cheap = target.is_leaf() && target.size() * source.size() <= direct_pairs_;
      (cheap ? near : far).emplace_back(t, s);
    } else if (target.is_leaf() && source.is_leaf()) {
      near.emplace_back(t, s);
    } else if (source.is_leaf() || (!target.is_leaf() && target.radius >= source.radius)) {
      for (Index c = target.first_child; c < target.last_child; ++c) visit(c, s);
    } else {
      for (Index c = source.first_child; c < source.last_child; ++c) visit(t, c);
    }
  }

  const std::vector<Box>&targets_, &sources_;
  Index direct_pairs_;
};

// The pairs' sources, sorted by target.
Lists by_target(const std::vector<BoxPair>& pairs, std::size_t count) {
  Lists lists{std::vector<Index>(count + 1, 0), std::vector<Index>(pairs.size())};
  for (const BoxPair& pair : pairs) ++lists.begin[static_cast<std::size_t>(pair.first) + 1];
  for (std::size_t t = 0; t < count; ++t) lists.begin[t + 1] += lists.begin[t];
  std::vector<Index> next(lists.begin.begin(), lists.begin.end() - 1);
  for (const BoxPair& pair : pairs) {
    lists.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(pair.first)]++)] =
        pair.second;
  }
  return lists;
}

// Ranges of points of each list's boxes; neighbouring ones become one.
Lists as_ranges(const Lists& lists, const std::vector<Box>& sources) {
  Lists ranges{{0}, {}};
  for (std::size_t t = 0; t + 1 < lists.begin.size(); ++t) {
    std::vector<std::pair<Index, Index>> of_target;
    for (Index i = lists.begin[t]; i < lists.begin[t + 1]; ++i) {
      const Box& source =
          sources[static_cast<std::size_t>(lists.entries[static_cast<std::size_t>(i)])];
      of_target.emplace_back(source.first, source.last);
    }
    std::sort(of_target.begin(), of_target.end());
    for (std::size_t i = 0; i < of_target.size(); ++i) {
      if (i > 0 && of_target[i].first == of_target[i - 1].second) {
        ranges.entries.back() = of_target[i].second;
      } else {
        ranges.entries.insert(ranges.entries.end(), {of_target[i].first, of_target[i].second});
      }
    }
    ranges.begin.push_back(static_cast<Index>(ranges.entries.size()));
  }
  return ranges;
}

}  // namespace

Interactions find_interactions(const Quadtree& targets, const Quadtree& sources,
                               Index direct_pairs) {
  const Traversal traversal(targets, sources, direct_pairs);
  const std::size_t count = targets.boxes().size();
  return {by_target(traversal.far, count),
          as_ranges(by_target(traversal.near, count), sources.boxes())};
}

}  // namespace stokesbook
