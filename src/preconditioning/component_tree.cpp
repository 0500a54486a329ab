// Builds the tree of groups that a HierarchicalPreconditioner eliminates one after another
// (chapter 13, section "A tree of groups").
#include "preconditioning/component_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Returns where a group begins if n components are divided into 2^m equal groups.
Index begin_of(Index group, int m, Index n) {
  return (n * group) >> m;
}

// Orders the components of a group of 2^m groups so that each of its parts, down to the groups of
// 2^most, is one half of the part that contains it.
void divide(const std::vector<Box>& disks, std::vector<Index>& order, Index group, int m,
            int most) {
  if (m == most) return;
  const Index n = std::ssize(order);
  const auto from = order.begin() + begin_of(group, m, n),
             middle = order.begin() + begin_of(2 * group + 1, m + 1, n),
             to = order.begin() + begin_of(group + 1, m, n);
  if (to - from < 2) return;
  const auto centre = [&](Index k) { return disks[static_cast<std::size_t>(k)].centre; };
  const auto x = [&](Index k) { return std::pair(centre(k).real(), k); };
  const auto y = [&](Index k) { return std::pair(centre(k).imag(), k); };
  const auto [left, right] = std::ranges::minmax_element(from, to, {}, x);
  const auto [lower, upper] = std::ranges::minmax_element(from, to, {}, y);
  if (x(*right).first - x(*left).first > y(*upper).first - y(*lower).first) {
    std::ranges::nth_element(from, middle, to, {}, x);
  } else {
    std::ranges::nth_element(from, middle, to, {}, y);
  }
  divide(disks, order, 2 * group, m + 1, most);
  divide(disks, order, 2 * group + 1, m + 1, most);
}

// Sets the disk of a group to the smallest one about the disks of its children whose centre is that
// of their bounding rectangle.
void surround(Box& group, const std::vector<Box>& below) {
  const auto first = below.begin() + group.first_child, last = below.begin() + group.last_child;
  Complex lower = first->centre, upper = first->centre;
  for (auto child = first; child != last; ++child) {
    const double r = child->radius;
    lower = {std::min(lower.real(), child->centre.real() - r),
             std::min(lower.imag(), child->centre.imag() - r)};
    upper = {std::max(upper.real(), child->centre.real() + r),
             std::max(upper.imag(), child->centre.imag() + r)};
  }
  group.centre = 0.5 * (lower + upper);
  for (auto child = first; child != last; ++child) {
    group.radius = std::max(group.radius, std::abs(child->centre - group.centre) + child->radius);
  }
}

}  // namespace

ComponentTree::ComponentTree(const std::vector<Box>& disks) : order(disks.size()) {
  const Index n = std::ssize(disks);
  std::iota(order.begin(), order.end(), Index{0});
  int depth = 0;  // number of levels above the components
  while (Index{1} << (2 * depth) < n) ++depth;
  divide(disks, order, 0, 0, 2 * depth);
  levels.emplace_back();
  for (Index k = 0; k < n; ++k) {
    Box single = disks[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
    single.first = single.first_child = k;
    single.last = single.last_child = k + 1;
    levels.back().push_back(single);
  }
  for (int m = 2 * (depth - 1); m >= 0; m -= 2) {
    std::vector<Box> groups;
    const std::vector<Box>& below = levels.back();
    Index child = 0;
    for (Index k = 0; k < Index{1} << m; ++k) {
      Box group;
      group.first = begin_of(k, m, n);
      group.last = begin_of(k + 1, m, n);
      if (group.size() == 0) continue;
      group.first_child = child;
      while (child < std::ssize(below) && below[static_cast<std::size_t>(child)].last <= group.last)
        ++child;
      group.last_child = child;
      surround(group, below);
      groups.push_back(group);
    }
    levels.push_back(std::move(groups));
  }
}

std::vector<std::vector<Index>> near_groups(const std::vector<Box>& groups, double reach) {
  std::vector<Rectangle> squares;
  for (const Box& group : groups) squares.push_back(square_about(group.centre, group.radius));
  const RectangleIndex index(squares);
  double largest = 0.0;
  for (const Box& group : groups) largest = std::max(largest, group.radius);
  std::vector<std::vector<Index>> near(groups.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < groups.size(); ++a) {
    const double farthest = reach * (groups[a].radius + largest);
    for (const std::size_t b : index.meeting(square_about(groups[a].centre, farthest))) {
      if (b != a && std::abs(groups[a].centre - groups[b].centre) <
                        reach * (groups[a].radius + groups[b].radius)) {
        near[a].push_back(static_cast<Index>(b));
      }
    }
  }
  return near;
}

}  // namespace stokesbook
