#pragma once

#include <functional>
#include <vector>

#include "stiv/edge_run.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// Where a polygon is closest to a point.
struct ClosestPoint {
  double distance;    ///< of the point, > 0 in the polygon's fluid, < 0 beyond it; length
  Complex point;      ///< of the polygon, length
  Complex normal;     ///< gradient of the distance, unit: into the fluid; also where that is 0
  Eigen::Index edge;  ///< that holds the point: from vertex edge to the next one
};

/// A closed polygon in its own frame, whose closest edges are found without looking at all of them:
/// runs of eight consecutive edges, each looked at as one, have bounding rectangles, and pairs of
/// those have theirs.
///
/// Safe to ask from several threads at once.
class Polygon {
 public:
  /// Sorts the edges.
  ///
  /// @param  vertices  M of them, counter-clockwise, no two consecutive ones equal, length
  /// @param  side      where the fluid lies
  /// @throws std::invalid_argument when there are fewer than three, or one is not finite
  /// @par Cost         O(M)
  Polygon(const ComplexVector& vertices, Side side);

  /// Counts vertices, and edges.
  /// @return M
  Eigen::Index size() const { return vertices_.size(); }

  /// Returns a vertex.
  /// @param  i  its number, 0 to M - 1
  /// @return    place in the polygon's frame, length
  Complex vertex(Eigen::Index i) const { return vertices_[i]; }

  /// Returns all vertices.
  /// @return M places in the polygon's frame, length
  const ComplexVector& vertices() const { return vertices_; }

  /// Tells where the fluid lies.
  /// @return side
  Side side() const { return side_; }

  /// Returns the least rectangle that holds the polygon.
  /// @return rectangle in the polygon's frame
  const Rectangle& bounds() const { return boxes_[1]; }

  /// Finds the point of the polygon that is closest to a point.
  ///
  /// @param  z        point, length
  /// @param  at_most  distance beyond which none is looked for, length; may be infinite
  /// @return          closest point; its distance is infinite where none is as near as at_most
  /// @par Accuracy  rounding of the positions, @ref claim_10_18
  /// @par Cost      O(log M) where one part of the polygon is clearly the closest, O(M) from the
  /// centre of a circle; no allocation
  ClosestPoint closest(Complex z, double at_most) const;

  /// Tells whether a straight piece of a path keeps away from the polygon.
  ///
  /// @param  chord     start and end, length
  /// @param  distance  to keep, >= 0, length
  /// @return           true when all points of the chord are farther than that from all edges
  /// @par Cost         as closest()
  bool is_clear_of(const Chord& chord, double distance) const;

  /// What is asked of a rectangle that holds some of the vertices.
  using Condition = std::function<bool(const Rectangle&)>;

  /// Finds the vertices of the runs whose rectangles fulfil a condition.
  ///
  /// @param  holds  whether a rectangle may hold a vertex that is sought, in the polygon's frame
  /// @return        numbers of vertices, ascending: all that are sought, and others of their runs
  /// @par Cost      O(log M + m) for m vertices of one part of the polygon
  std::vector<Eigen::Index> vertices_if(const Condition& holds) const;

  /// Finds the vertices in a rectangle, borders included.
  ///
  /// @param  rectangle  in the polygon's frame
  /// @return            numbers of vertices, ascending
  /// @par Cost          O(log M + m) for m vertices of one part of the polygon
  std::vector<Eigen::Index> vertices_in(const Rectangle& rectangle) const;

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Nearest;
  /// @endcond

  Chord edge(Eigen::Index number) const;
  Eigen::Index first_edge(std::size_t leaf) const;
  void search(std::size_t node, Complex z, Nearest& nearest) const;
  bool is_clear_of(std::size_t node, const Chord& chord, double distance,
                   const Rectangle& surroundings) const;
  void collect(std::size_t node, const Condition& holds, std::vector<Eigen::Index>& found) const;

  ComplexVector vertices_;
  Side side_;
  std::size_t leaf_count_ = 1;    // a power of two
  std::vector<EdgeRun> runs_;     // of the leaves; the last edge fills up the last one
  std::vector<Rectangle> boxes_;  // of nodes 1, 2, ...: 2 k and 2 k + 1 are the children of node k
};

/// @}

}  // namespace stokesbook
