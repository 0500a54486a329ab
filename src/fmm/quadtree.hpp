#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A box of a quadtree: points that are consecutive in the tree's order, and the disk about them.
struct Box {
  Eigen::Index first = 0;        ///< first of its points
  Eigen::Index last = 0;         ///< one beyond the last of them
  Eigen::Index parent = -1;      ///< index of the parent; -1 for the root
  Eigen::Index first_child = 0;  ///< index of the first child
  Eigen::Index last_child = 0;   ///< one beyond that of the last child
  Complex centre;                ///< centre of the points' bounding rectangle, length
  double radius = 0.0;  ///< radius of the disk about the centre that holds all points with margins;
                        ///< at least 1e-100, so that divisions by it are finite, length

  Eigen::Index size() const { return last - first; }          ///< counts the points
  bool is_leaf() const { return first_child == last_child; }  ///< returns true without children
};

/// An adaptive quadtree. Boxes with too many points are divided at the middle of their points'
/// bounding rectangle, and empty children are left out.
struct Quadtree {
  /// Builds the tree, with O(n log n) operations.
  ///
  /// @param  points     n finite points, length
  /// @param  margins    for each point the radius of a circle about the point that the disk of its
  ///                    box must contain, >= 0, length; empty if all are zero
  /// @param  leaf_size  largest number of points of a leaf, >= 1; coincident points stay together,
  ///                    whatever their number
  /// @throws std::invalid_argument when a point or margin is not finite, or the leaf size is < 1
  Quadtree(const ComplexVector& points, const Eigen::VectorXd& margins, Eigen::Index leaf_size);

  Eigen::Index size() const { return x.size(); }                ///< counts the points
  Eigen::Index box_count() const { return std::ssize(boxes); }  ///< counts the boxes

  std::vector<Eigen::Index> order;  ///< order of the points in the tree: indices into the points
  Eigen::VectorXd x;                ///< first coordinates in this order, length
  Eigen::VectorXd y;                ///< second coordinates, length
  std::vector<Box> boxes;           ///< level by level, the root first
  std::vector<Eigen::Index> levels = {0};  ///< first box of each level, and the end of all boxes
};

}  // namespace stokesbook
