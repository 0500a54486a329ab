// Finds the near and far interactions between the boxes of two trees by a dual-tree traversal, with
// the separation (08.8).
#include "fmm/interactions.hpp"

#include <algorithm>

namespace stokesbook {

using Eigen::Index;

namespace {

struct BoxPair {
  Index target, source;
};

// Both conditions of (08.8) with rho = 1/2: R_t + R_s + max(R_t, R_s) < |D|. The strict inequality
// excludes boxes at the same place, however small.
bool well_separated(const Box& target, const Box& source) {
  const double reach = target.radius + source.radius + std::max(target.radius, source.radius);
  return reach * reach < std::norm(target.centre - source.centre);
}

class Traversal {
 public:
  Traversal(const Quadtree& targets, const Quadtree& sources, Index direct_pairs)
      : targets_(targets.boxes), sources_(sources.boxes), direct_pairs_(direct_pairs) {
    if (!targets_.empty() && !sources_.empty()) visit({0, 0});
  }

  std::vector<BoxPair> far, near;

 private:
  // [visit]
  void visit(BoxPair pair) {
    const Box& target = targets_[static_cast<std::size_t>(pair.target)];
    const Box& source = sources_[static_cast<std::size_t>(pair.source)];
    if (well_separated(target, source)) {
      const bool cheap = target.is_leaf() && target.size() * source.size() <= direct_pairs_;
      (cheap ? near : far).push_back(pair);
    } else if (target.is_leaf() && source.is_leaf()) {
      near.push_back(pair);
    } else if (source.is_leaf() || (!target.is_leaf() && target.radius >= source.radius)) {
      for (Index c = target.first_child; c < target.last_child; ++c) visit({c, pair.source});
    } else {
      for (Index c = source.first_child; c < source.last_child; ++c) visit({pair.target, c});
    }
  }
  // [visit]

  const std::vector<Box>&targets_, &sources_;
  Index direct_pairs_;
};

// Makes the list of sources of every target from all pairs, by a counting sort.
Lists<Index> by_target(const std::vector<BoxPair>& pairs, std::size_t count) {
  Lists<Index> lists{std::vector<Index>(count + 1, 0), std::vector<Index>(pairs.size())};
  for (const BoxPair& pair : pairs) ++lists.begin[static_cast<std::size_t>(pair.target) + 1];
  for (std::size_t t = 0; t < count; ++t) lists.begin[t + 1] += lists.begin[t];
  std::vector<Index> next(lists.begin.begin(), lists.begin.end() - 1);
  for (const BoxPair& pair : pairs) {
    const Index place = next[static_cast<std::size_t>(pair.target)]++;
    lists.entries[static_cast<std::size_t>(place)] = pair.source;
  }
  return lists;
}

// Replaces the boxes of each list by the ranges of their points. The sources of a target are in the
// order of their tree, so that the points of neighbouring boxes form one range.
Lists<Range> as_ranges(const Lists<Index>& lists, const std::vector<Box>& sources) {
  Lists<Range> ranges{{0}, {}};
  for (std::size_t t = 0; t + 1 < lists.begin.size(); ++t) {
    const auto first = static_cast<std::size_t>(ranges.begin.back());
    for (const Index s : lists.of(static_cast<Index>(t))) {
      const Box& source = sources[static_cast<std::size_t>(s)];
      if (ranges.entries.size() > first && ranges.entries.back().last == source.first) {
        ranges.entries.back().last = source.last;
      } else {
        ranges.entries.push_back({source.first, source.last});
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
  const std::size_t count = targets.boxes.size();
  return {by_target(traversal.far, count),
          as_ranges(by_target(traversal.near, count), sources.boxes)};
}

}  // namespace stokesbook
