// Builds an adaptive quadtree with tight boxes, level by level from the root (chapter 08).
#include "fmm/quadtree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "trapezoid/rectangle_index.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

void require_valid(const ComplexVector& points, const Eigen::VectorXd& margins, Index leaf_size) {
  require(leaf_size >= 1, "the leaf size of a quadtree must be >= 1, got ", leaf_size);
  require(margins.size() == 0 || margins.size() == points.size(), "a quadtree of ", points.size(),
          " points got ", margins.size(), " margins");
  for (Index i = 0; i < points.size(); ++i) {
    const double margin = margins.size() == 0 ? 0.0 : margins[i];
    require(std::isfinite(std::norm(points[i])) && std::isfinite(margin), "point ", i,
            " of a quadtree is not finite: ", points[i], ", margin ", margin);
  }
}

// Returns a box with the centre of its points' bounding rectangle, and the disk about it.
Box enclose(const ComplexVector& points, const Eigen::VectorXd& margins,
            std::span<const Index> indices) {
  const auto [lower, upper] = bounding_rectangle(points(indices));
  Box box;
  box.centre = 0.5 * (lower + upper);
  box.radius = 1e-100;
  for (const Index i : indices) {
    const Complex r = points[i] - box.centre;
    box.radius = std::max(box.radius, std::sqrt(std::norm(r)) + margins[i]);
  }
  return box;
}

// Sorts the indices of a box's points by quadrant, in their present order within each quadrant.
// Returns the place at which each quadrant begins, and the end of the last quadrant.
std::array<Index, 5> sort_by_quadrant(const ComplexVector& points, Complex centre,
                                      std::span<Index> indices) {
  const auto is_left = [&](Index i) { return points[i].real() <= centre.real(); };
  const auto is_below = [&](Index i) { return points[i].imag() <= centre.imag(); };
  const auto begin = indices.begin(), end = indices.end();
  const auto above = std::stable_partition(begin, end, is_below);
  const auto right_below = std::stable_partition(begin, above, is_left);
  const auto right_above = std::stable_partition(above, end, is_left);
  return {0, right_below - begin, above - begin, right_above - begin, end - begin};
}

}  // namespace

Quadtree::Quadtree(const ComplexVector& points, const Eigen::VectorXd& margins, Index leaf_size)
    : order(static_cast<std::size_t>(points.size())) {
  require_valid(points, margins, leaf_size);
  const Index n = points.size();
  const Eigen::VectorXd all_margins = margins.size() == n ? margins : Eigen::VectorXd::Zero(n);
  std::iota(order.begin(), order.end(), Index{0});
  const auto indices = [&](Index first, Index last) {
    return std::span(order).subspan(static_cast<std::size_t>(first),
                                    static_cast<std::size_t>(last - first));
  };
  const auto append_box = [&](Index first, Index last, Index parent) {
    boxes.push_back(enclose(points, all_margins, indices(first, last)));
    boxes.back().first = first;
    boxes.back().last = last;
    boxes.back().parent = parent;
  };
  if (n > 0) {
    append_box(0, n, -1);
    levels.push_back(1);
  }
  // Children are appended in the order of their parents, so that the boxes are sorted by level.
  for (Index b = 0; b < box_count(); ++b) {
    if (b == levels.back()) levels.push_back(box_count());
    const Box box = boxes[static_cast<std::size_t>(b)];
    if (box.size() <= leaf_size) continue;
    const std::array<Index, 5> begin =
        sort_by_quadrant(points, box.centre, indices(box.first, box.last));
    const Index first_child = box_count();
    for (std::size_t q = 0; q < 4; ++q) {
      // If all points are in one quadrant, they coincide, or no floating-point number lies between
      // them: the box stays a leaf.
      const Index size = begin[q + 1] - begin[q];
      if (size == 0 || size == box.size()) continue;
      append_box(box.first + begin[q], box.first + begin[q + 1], b);
    }
    if (box_count() == first_child) continue;
    boxes[static_cast<std::size_t>(b)].first_child = first_child;
    boxes[static_cast<std::size_t>(b)].last_child = box_count();
  }
  x = points(order).real();
  y = points(order).imag();
}

}  // namespace stokesbook
