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
  Complex centre;                ///< of the points' bounding rectangle, length
  double radius = 0.0;  ///< of the disk about the centre that contains every point with its margin;
                        ///< at least 1e-100, so that divisions by it are finite, length

  /// Counts the points.
  Eigen::Index size() const { return last - first; }

  /// Returns whether the box has no children.
  bool is_leaf() const { return first_child == last_child; }
};

/// An adaptive quadtree. Boxes with too many points are divided at the middle of their points'
/// bounding rectangle, and empty children are left out.
class Quadtree {
 public:
  /// Builds the tree.
  ///
  /// @param  points     n finite points, length
  /// @param  margins    for each point the radius of a circle about the point that the disk of its
  ///                    box must contain, >= 0, length; empty if all are zero
  /// @param  leaf_size  largest number of points of a leaf, >= 1; coincident points stay together,
  ///                    whatever their number
  /// @throws std::invalid_argument when a point or margin is not finite, or the leaf size is < 1
  /// @par Cost          O(n log n)
  Quadtree(const ComplexVector& points, const Eigen::VectorXd& margins, Eigen::Index leaf_size);

  /// Returns the boxes, level by level, the root first; none if there are no points.
  const std::vector<Box>& boxes() const { return boxes_; }

  /// Returns the indices in boxes() at which the levels begin, and the end of the last level.
  const std::vector<Eigen::Index>& levels() const { return levels_; }

  /// Returns the order of the points in the tree: n indices into the constructor's points.
  const std::vector<Eigen::Index>& order() const { return order_; }

  /// Returns the first coordinates of the points in the tree's order.
  const Eigen::VectorXd& x() const { return x_; }

  /// Returns the second coordinates of the points in the tree's order.
  const Eigen::VectorXd& y() const { return y_; }

  /// Counts the points.
  Eigen::Index size() const { return x_.size(); }

 private:
  std::vector<Eigen::Index> order_;
  Eigen::VectorXd x_, y_;
  std::vector<Box> boxes_;
  std::vector<Eigen::Index> levels_ = {0};
};

}  // namespace stokesbook
