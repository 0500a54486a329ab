#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "fmm/quadtree.hpp"

namespace stokesbook {

/// A tree in which at most four groups of components are united at a time, level by level, up to a
/// single group.
struct ComponentTree {
  /// Builds the tree by dividing the components at the medians of their positions along the longer
  /// side of their bounding rectangle.
  ///
  /// @param  disks  a disk about each component: centre and radius, the other members are not
  ///                read; at least one
  /// @par Cost      O(n log n) for n components
  explicit ComponentTree(const std::vector<Box>& disks);

  std::vector<Eigen::Index> order;  ///< components in the order of the tree
  /// The groups of each level with the disks about their components. The points of a group are the
  /// components from `first` to `last` in the tree's order. Its children are groups of the level
  /// below. On the lowest level, a group is one component, which is its only child, too.
  std::vector<std::vector<Box>> levels;
};

/// Finds the groups of a level that are coupled to each group by blocks, ascending: those whose
/// centres are less than `reach` times the sum of the radii apart.
std::vector<std::vector<Eigen::Index>> near_groups(const std::vector<Box>& groups, double reach);

}  // namespace stokesbook
