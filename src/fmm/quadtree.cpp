// Builds an adaptive quadtree with tight boxes, level by level from the root (chapter 08).
#include "fmm/quadtree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double least_radius = 1e-100;

void check_points(const ComplexVector& points, const Eigen::VectorXd& margins, Index leaf_size) {
  if (leaf_size < 1) {
    throw std::invalid_argument("the leaf size of a quadtree must be >= 1, got " +
                                std::to_string(leaf_size));
  }
  if (margins.size() != 0 && margins.size() != points.size()) {
    throw std::invalid_argument("a quadtree of " + std::to_string(points.size()) + " points got " +
                                std::to_string(margins.size()) + " margins");
  }
  for (Index i = 0; i < points.size(); ++i) {
    const double margin = margins.size() == 0 ? 0.0 : margins[i];
    if (std::isfinite(std::norm(points[i])) && std::isfinite(margin)) continue;
    std::ostringstream message;
    message << "point " << i << " of a quadtree is not finite: " << points[i] << ", margin "
            << margin;
    throw std::invalid_argument(message.str());
  }
}

}  // namespace

// Copies of the points of the box that is being divided.
struct Quadtree::Scratch {
  std::vector<Index> order;
  Eigen::VectorXd x, y, margins;
};

Quadtree::Quadtree(const ComplexVector& points, const Eigen::VectorXd& margins, Index leaf_size)
    : order_(static_cast<std::size_t>(points.size())), x_(points.real()), y_(points.imag()) {
  check_points(points, margins, leaf_size);
  const Index n = points.size();
  margins_ = margins.size() == n ? margins : Eigen::VectorXd::Zero(n);
  std::iota(order_.begin(), order_.end(), Index{0});
  if (n == 0) return;
  Scratch scratch{order_, x_, y_, margins_};
  boxes_.push_back(enclose(0, n, -1));
  levels_.push_back(1);
  // Children are appended in the order of their parents, so that the boxes are sorted by level.
  for (Index b = 0; b < static_cast<Index>(boxes_.size()); ++b) {
    if (b == levels_.back()) levels_.push_back(static_cast<Index>(boxes_.size()));
    if (boxes_[static_cast<std::size_t>(b)].size() > leaf_size) divide(b, scratch);
  }
}

Box Quadtree::enclose(Index first, Index last, Index parent) const {
  double low_x = x_[first], low_y = y_[first], high_x = low_x, high_y = low_y;
  for (Index i = first; i < last; ++i) {
    low_x = std::min(low_x, x_[i]);
    high_x = std::max(high_x, x_[i]);
    low_y = std::min(low_y, y_[i]);
    high_y = std::max(high_y, y_[i]);
  }
  Box box;
  box.first = first;
  box.last = last;
  box.parent = parent;
  box.centre = 0.5 * Complex{low_x + high_x, low_y + high_y};
  box.radius = least_radius;
  for (Index i = first; i < last; ++i) {
    const double x = x_[i] - box.centre.real(), y = y_[i] - box.centre.imag();
    box.radius = std::max(box.radius, std::sqrt(x * x + y * y) + margins_[i]);
  }
  return box;
}

// Divides a box: sorts its points by quadrant (counting sort), and appends the children.
void Quadtree::divide(Index parent, Scratch& scratch) {
  const Box box = boxes_[static_cast<std::size_t>(parent)];
  const auto quadrant = [&](double x, double y) {
    return static_cast<std::size_t>((x > box.centre.real() ? 1 : 0) +
                                    (y > box.centre.imag() ? 2 : 0));
  };
  std::array<Index, 5> begin{};  // of each quadrant's points
  for (Index i = box.first; i < box.last; ++i) ++begin[quadrant(x_[i], y_[i]) + 1];
  // All points are in one quadrant: they coincide, or no floating-point number lies between them.
  // The box stays a leaf.
  if (*std::max_element(begin.begin(), begin.end()) == box.size()) return;
  begin[0] = box.first;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (Index i = box.first; i < box.last; ++i) {
    scratch.x[i] = x_[i];
    scratch.y[i] = y_[i];
    scratch.margins[i] = margins_[i];
    scratch.order[static_cast<std::size_t>(i)] = order_[static_cast<std::size_t>(i)];
  }
  std::array<Index, 5> next = begin;
  for (Index i = box.first; i < box.last; ++i) {
    const Index to = next[quadrant(scratch.x[i], scratch.y[i])]++;
    x_[to] = scratch.x[i];
    y_[to] = scratch.y[i];
    margins_[to] = scratch.margins[i];
    order_[static_cast<std::size_t>(to)] = scratch.order[static_cast<std::size_t>(i)];
  }
  const auto first_child = static_cast<Index>(boxes_.size());
  for (std::size_t q = 0; q < 4; ++q) {
    if (begin[q] < begin[q + 1]) boxes_.push_back(enclose(begin[q], begin[q + 1], parent));
  }
  boxes_[static_cast<std::size_t>(parent)].first_child = first_child;
  boxes_[static_cast<std::size_t>(parent)].last_child = static_cast<Index>(boxes_.size());
}

}  // namespace stokesbook
