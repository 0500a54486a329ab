// Finds the near and far interactions between the boxes of two trees by a dual-tree traversal, with
// the separation (08.8).
#include "fmm/interactions.hpp"

#include <algorithm>
#include <utility>

namespace stokesbook {

using Eigen::Index;

namespace {

// Both conditions of (08.8) with rho = 1/2: R_t + R_s + max(R_t, R_s) < |D|. The strict inequality
// excludes boxes at the same place, however small.
bool well_separated(const Box& target, const Box& source, Complex shift) {
  const double reach = target.radius + source.radius + std::max(target.radius, source.radius);
  return reach * reach < std::norm(target.centre - source.centre - shift);
}

// Adds the points of a box to the ranges of one target. The sources of a target are in the order of
// their tree, so that the points of neighbouring boxes form one range.
void append(const Box& box, std::vector<Range>& ranges) {
  if (!ranges.empty() && ranges.back().last == box.first) {
    ranges.back().last = box.last;
  } else {
    ranges.push_back({box.first, box.last});
  }
}

struct Traversal {
  const std::vector<Box>&targets, &sources;
  Index direct_pairs;
  Interactions found;

  void visit(std::size_t t, std::size_t s) {
    const Box &target = targets[t], &source = sources[s];
    const bool separated = well_separated(target, source, found.shift);
    const bool cheap = target.is_leaf() && target.size() * source.size() <= direct_pairs;
    if (separated && !cheap) {
      found.far[t].push_back(static_cast<Index>(s));
    } else if (separated || (target.is_leaf() && source.is_leaf())) {
      append(source, found.near[t]);
    } else if (source.is_leaf() || (!target.is_leaf() && target.radius >= source.radius)) {
      for (Index c = target.first_child; c < target.last_child; ++c) {
        visit(static_cast<std::size_t>(c), s);
      }
    } else {
      for (Index c = source.first_child; c < source.last_child; ++c) {
        visit(t, static_cast<std::size_t>(c));
      }
    }
  }
};

}  // namespace

Interactions find_interactions(const Quadtree& targets, const Quadtree& sources, Index direct_pairs,
                               Complex shift) {
  const std::size_t count = targets.boxes.size();
  Traversal traversal{targets.boxes, sources.boxes, direct_pairs, {shift, {}, {}}};
  traversal.found.far.resize(count);
  traversal.found.near.resize(count);
  if (count > 0 && !sources.boxes.empty()) traversal.visit(0, 0);
  return std::move(traversal.found);
}

}  // namespace stokesbook
