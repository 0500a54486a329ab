#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A rectangle with sides along the axes.
struct Rectangle {
  Complex lower;  ///< corner with the smallest x and y, length
  Complex upper;  ///< corner with the largest x and y, length
};

/// Returns the bounding square of a circle, whose radius may be infinite.
Rectangle square_about(Complex centre, double radius);

/// Moves the sides of a rectangle outward by a distance, which may be infinite.
Rectangle widened(const Rectangle& rectangle, double distance);

/// Returns the smallest rectangle that contains the given points, at least one.
Rectangle bounding_rectangle(const Eigen::Ref<const ComplexVector>& points);

/// Finds the rectangles, among many, that intersect a given one, by an R-tree. This step is the
/// broad phase of a search for neighbours.
///
/// Several threads may call meeting() at the same time.
class RectangleIndex {
 public:
  /// Packs n rectangles into a tree. The number of a rectangle is its position, from 0 on.
  ///
  /// @throws std::invalid_argument when a corner is not finite
  /// @par Cost  O(n log n)
  explicit RectangleIndex(const std::vector<Rectangle>& rectangles = {});

  ~RectangleIndex();  ///< frees the tree

  /// Adds a rectangle, whose number is the number of rectangles before it, with O(log n)
  /// operations.
  ///
  /// @throws std::invalid_argument when a corner is not finite
  void insert(const Rectangle& rectangle);

  /// Returns the numbers, ascending, of the rectangles that intersect a given one, whose corners
  /// may be infinite; a common border point suffices.
  ///
  /// @par Cost  O(log n + m log m) for m rectangles found, if each one overlaps few others
  std::vector<std::size_t> meeting(const Rectangle& rectangle) const;

 private:
  // The tree is hidden, because Boost.Geometry compiles slowly: one source file includes it.
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace stokesbook
