#include "fmm/quadtree.hpp"

#include <array>
#include <cmath>
#include <numeric>

namespace stokesbook {

using Eigen::Index;

namespace {

int quadrant(Complex point, Complex centre) {
  return (point.real() > centre.real() ? 1 : 0) + (point.imag() > centre.imag() ? 2 : 0);
}

}  // namespace

Quadtree::Quadtree(const ComplexVector& points, Index leaf_size)
    : order_(static_cast<std::size_t>(points.size())), points_(points) {
  std::iota(order_.begin(), order_.end(), Index{0});
  if (points.size() == 0) return;
  boxes_.push_back(enclose(0, points.size(), -1));
  levels_ = {0, 1};
  // Children are appended in the order of their parents, so that levels follow each other.
  for (Index box = 0; box < static_cast<Index>(boxes_.size()); ++box) {
    const auto k = static_cast<std::size_t>(box);
    if (box == levels_.back()) levels_.push_back(static_cast<Index>(boxes_.size()));
    if (boxes_[k].size() > leaf_size && boxes_[k].radius > 0.0) divide(box);
  }
}

Box Quadtree::enclose(Index first, Index last, Index parent) const {
  const auto points = points_.segment(first, last - first);
  const Complex low{points.real().minCoeff(), points.imag().minCoeff()};
  const Complex high{points.real().maxCoeff(), points.imag().maxCoeff()};
  Box box{first, last, parent, 0, 0, 0.5 * (low + high), 0.0, 0.0};
  box.radius = std::sqrt((points.array() - box.centre).abs2().maxCoeff());
  const double least = parent < 0 ? 1.0 : 1e-8 * boxes_[static_cast<std::size_t>(parent)].scale;
  box.scale = box.radius > 0.0 ? box.radius : least;
  return box;
}

void Quadtree::divide(Index parent) {
  const Box box = boxes_[static_cast<std::size_t>(parent)];
  std::array<Index, 5> begin{};  // of each quadrant's points, relative to the box's
  for (Index i = box.first; i < box.last; ++i) {
    ++begin[static_cast<std::size_t>(quadrant(points_[i], box.centre)) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  const ComplexVector points = points_.segment(box.first, box.size());
  const std::vector<Index> order(order_.begin() + box.first, order_.begin() + box.last);
  std::array<Index, 5> next = begin;
  for (Index i = 0; i < box.size(); ++i) {
    const Index to = box.first + next[static_cast<std::size_t>(quadrant(points[i], box.centre))]++;
    points_[to] = points[i];
    order_[static_cast<std::size_t>(to)] = order[static_cast<std::size_t>(i)];
  }
  const auto first_child = static_cast<Index>(boxes_.size());
  for (std::size_t q = 0; q < 4; ++q) {
    if (begin[q] == begin[q + 1]) continue;
    boxes_.push_back(enclose(box.first + begin[q], box.first + begin[q + 1], parent));
  }
  boxes_[static_cast<std::size_t>(parent)].first_child = first_child;
  boxes_[static_cast<std::size_t>(parent)].last_child = static_cast<Index>(boxes_.size());
}

}  // namespace stokesbook
