#pragma once

#include <functional>
#include <vector>

#include "stiv/edge_run.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

/// The point of a polygon that is closest to a given point z.
struct ClosestPoint {
  double distance;    ///< signed distance of z, length: > 0 in the fluid, < 0 beyond the polygon
  Complex point;      ///< the closest point, length
  Complex normal;     ///< unit gradient of the distance, into the fluid; also at distance 0
  Eigen::Index edge;  ///< number of the edge with the closest point; edge i starts at vertex i
};

/// A closed polygon in its own frame, with a tree that finds its closest edges without a look at
/// all edges.
///
/// The leaves of the tree are runs of eight consecutive edges with their bounding rectangles; each
/// inner node has the bounding rectangle of its two children. The const member functions may be
/// called from several threads at once.
class Polygon {
 public:
  /// Builds the tree from M vertices, which are counter-clockwise; consecutive vertices differ.
  ///
  /// @throws std::invalid_argument when there are fewer than three vertices, or one is not finite
  /// @par Cost         O(M)
  Polygon(const ComplexVector& vertices, Side side);

  Eigen::Index size() const { return vertices_.size(); }  ///< returns the number M of vertices
  Complex vertex(Eigen::Index i) const { return vertices_[i]; }  ///< returns a vertex
  const ComplexVector& vertices() const { return vertices_; }    ///< returns all vertices
  Side side() const { return side_; }  ///< returns the side on which the fluid lies

  /// Returns the least rectangle that holds the polygon, in the polygon's frame.
  const Rectangle& bounds() const { return boxes_[1]; }

  /// Finds the point of the polygon that is closest to a point.
  ///
  /// @param  at_most  distance up to which the search looks, length; may be infinite
  /// @return          closest point; its distance is infinite and its edge -1 if the polygon is not
  ///                  nearer than at_most
  /// @par Accuracy    rounding of the positions, @ref claim_10_18
  /// @par Cost        O(log M) if one part of the polygon is clearly the closest, O(M) from the
  ///                  centre of a circle; no allocation
  ClosestPoint closest(Complex z, double at_most) const;

  /// Returns whether all points of a chord are farther than a distance >= 0 from all edges. The
  /// cost is like that of closest().
  bool is_clear_of(const Chord& chord, double distance) const;

  /// A condition on a rectangle that holds some of the vertices.
  using Condition = std::function<bool(const Rectangle&)>;

  /// Finds the vertices of the runs whose rectangles, in the polygon's frame, fulfil a condition:
  /// their numbers, ascending. The cost is O(log M + m) for m vertices of one part of the polygon.
  std::vector<Eigen::Index> vertices_if(const Condition& holds) const;

  /// Finds the vertices in a rectangle of the polygon's frame, including its border. Result and
  /// cost are like those of vertices_if().
  std::vector<Eigen::Index> vertices_in(const Rectangle& rectangle) const;

 private:
  Chord edge(Eigen::Index number) const;
  Eigen::Index first_edge(std::size_t leaf) const;
  void search(std::size_t node, Complex z, EdgeRun::Closest& nearest) const;
  bool is_clear_of(std::size_t node, const Chord& chord, double distance,
                   const Rectangle& surroundings) const;
  void collect(std::size_t node, const Condition& holds, std::vector<Eigen::Index>& found) const;

  ComplexVector vertices_;
  Side side_;
  std::size_t leaf_count_ = 1;    // a power of two
  std::vector<EdgeRun> runs_;     // one for each leaf; copies of the last edge fill the last run
  std::vector<Rectangle> boxes_;  // boxes of nodes 1, 2, ...; node k has the children 2 k, 2 k + 1
};

}  // namespace stokesbook
