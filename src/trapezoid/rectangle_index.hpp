#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup trapezoid
/// @{

/// A rectangle with sides along the axes.
struct Rectangle {
  Complex lower;  ///< corner of the least x and y, length
  Complex upper;  ///< corner of the largest x and y, length
};

/// Returns the square about a circle.
///
/// @param  centre  of the circle, length
/// @param  radius  of the circle, length; may be infinite
/// @return         the least rectangle that holds the circle
Rectangle square_about(Complex centre, double radius);

/// Moves the sides of a rectangle outward.
///
/// @param  rectangle  any
/// @param  distance   of the new sides from the old ones, length; may be infinite
/// @return            the wider rectangle
Rectangle widened(const Rectangle& rectangle, double distance);

/// Returns the least rectangle that holds some points.
///
/// @param  points  at least one, length
/// @return         their bounding rectangle
Rectangle bounding_rectangle(const Eigen::Ref<const ComplexVector>& points);

/// Finds which of many rectangles meet one: the broad phase of searches for neighbours, by an
/// R-tree.
///
/// Safe to ask from several threads at once.
class RectangleIndex {
 public:
  /// Packs rectangles into a tree.
  ///
  /// @param  rectangles  n of them, known by their places from 0 on
  /// @throws std::invalid_argument when a corner is not finite
  /// @par Cost           O(n log n)
  explicit RectangleIndex(const std::vector<Rectangle>& rectangles = {});

  /// Frees the tree.
  ~RectangleIndex();

  /// Adds a rectangle, which is known by the number of those that were there before.
  ///
  /// @param  rectangle  the next one
  /// @throws std::invalid_argument when a corner is not finite
  /// @par Cost          O(log n)
  void insert(const Rectangle& rectangle);

  /// Finds the rectangles that meet one, borders included.
  ///
  /// @param  rectangle  any; corners may be infinite
  /// @return            their numbers, ascending
  /// @par Cost          O(log n + m log m) for m that meet it, when rectangles overlap few others
  std::vector<std::size_t> meeting(const Rectangle& rectangle) const;

 private:
  // Hidden, because Boost.Geometry compiles slowly: one source reads it.
  /// @cond
  struct Tree;
  /// @endcond
  std::unique_ptr<Tree> tree_;
};

/// @}

}  // namespace stokesbook
