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

// Where each quadrant of a divided box begins in the tree's order; all zero where it stays whole.
struct Quadtree::Division {
  std::array<Index, 5> begin{};
};

Quadtree::Quadtree(const ComplexVector& points, const Eigen::VectorXd& margins, Index leaf_size)
    : order_(static_cast<std::size_t>(points.size())), x_(points.real()), y_(points.imag()) {
  check_points(points, margins, leaf_size);
  const Index n = points.size();
  margins_ = margins.size() == n ? margins : Eigen::VectorXd::Zero(n);
  std::iota(order_.begin(), order_.end(), Index{0});
  if (n == 0) return;
  Quadtree scratch;
  scratch.order_.resize(order_.size());
  for (Eigen::VectorXd* array : {&scratch.x_, &scratch.y_, &scratch.margins_}) array->resize(n);
  boxes_.push_back({});
  boxes_[0].last = n;
  enclose(boxes_[0]);
  std::vector<Division> divisions;
  for (Index first = 0; first < static_cast<Index>(boxes_.size());) {
    const auto last = static_cast<Index>(boxes_.size());
    levels_.push_back(last);
    divisions.assign(static_cast<std::size_t>(last - first), {});
#pragma omp parallel for schedule(dynamic, 8)
    for (Index b = first; b < last; ++b) {
      const Box& box = boxes_[static_cast<std::size_t>(b)];
      if (box.size() > leaf_size) {
        divisions[static_cast<std::size_t>(b - first)] = divide(box, scratch);
      }
    }
    for (Index b = first; b < last; ++b) {
      const std::array<Index, 5>& begin = divisions[static_cast<std::size_t>(b - first)].begin;
      const auto first_child = static_cast<Index>(boxes_.size());
      for (std::size_t q = 0; q < 4; ++q) {
        if (begin[q] == begin[q + 1]) continue;
        boxes_.push_back({});
        boxes_.back().first = begin[q];
        boxes_.back().last = begin[q + 1];
        boxes_.back().parent = b;
      }
      Box& box = boxes_[static_cast<std::size_t>(b)];
      box.first_child = first_child;
      box.last_child = static_cast<Index>(boxes_.size());
    }
#pragma omp parallel for schedule(dynamic, 8)
    for (Index b = last; b < static_cast<Index>(boxes_.size()); ++b) {
      enclose(boxes_[static_cast<std::size_t>(b)]);
    }
    first = last;
  }
}

void Quadtree::enclose(Box& box) const {
  double low_x = x_[box.first], low_y = y_[box.first], high_x = low_x, high_y = low_y;
  for (Index i = box.first; i < box.last; ++i) {
    low_x = std::min(low_x, x_[i]);
    high_x = std::max(high_x, x_[i]);
    low_y = std::min(low_y, y_[i]);
    high_y = std::max(high_y, y_[i]);
  }
  box.centre = 0.5 * Complex{low_x + high_x, low_y + high_y};
  double radius = least_radius;
  for (Index i = box.first; i < box.last; ++i) {
    const double x = x_[i] - box.centre.real(), y = y_[i] - box.centre.imag();
    radius = std::max(radius, std::sqrt(x * x + y * y) + margins_[i]);
  }
  box.radius = radius;
}

// A counting sort by quadrant.
Quadtree::Division Quadtree::divide(const Box& box, Quadtree& scratch) {
  const auto quadrant = [&](double x, double y) {
    return static_cast<std::size_t>((x > box.centre.real() ? 1 : 0) +
                                    (y > box.centre.imag() ? 2 : 0));
  };
  Division division;
  std::array<Index, 5>& begin = division.begin;
  for (Index i = box.first; i < box.last; ++i) ++begin[quadrant(x_[i], y_[i]) + 1];
  // Coincident points, or points that no number lies between.
  if (*std::max_element(begin.begin(), begin.end()) == box.size()) return {};
  begin[0] = box.first;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  scratch.x_.segment(box.first, box.size()) = x_.segment(box.first, box.size());
  scratch.y_.segment(box.first, box.size()) = y_.segment(box.first, box.size());
  scratch.margins_.segment(box.first, box.size()) = margins_.segment(box.first, box.size());
  std::copy(order_.begin() + box.first, order_.begin() + box.last,
            scratch.order_.begin() + box.first);
  std::array<Index, 5> next = begin;
  for (Index i = box.first; i < box.last; ++i) {
    const Index to = next[quadrant(scratch.x_[i], scratch.y_[i])]++;
    x_[to] = scratch.x_[i];
    y_[to] = scratch.y_[i];
    margins_[to] = scratch.margins_[i];
    order_[static_cast<std::size_t>(to)] = scratch.order_[static_cast<std::size_t>(i)];
  }
  return division;
}

}  // namespace stokesbook
