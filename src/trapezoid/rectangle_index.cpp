// Finds the rectangles that intersect a given one, by the R-tree of Boost.Geometry.
#include "trapezoid/rectangle_index.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost 1.74 itself includes deprecated headers
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#if __has_include(<boost/geometry/strategies/cartesian.hpp>)
#include <boost/geometry/strategies/cartesian.hpp>  // newer versions require this header
#endif
#include <boost/iterator/function_output_iterator.hpp>

#include "trapezoid/require.hpp"

namespace stokesbook {

namespace {

namespace geometry = boost::geometry;

using Point = geometry::model::point<double, 2, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using Entry = std::pair<Box, std::size_t>;

Box to_box(const Rectangle& rectangle) {
  return {{rectangle.lower.real(), rectangle.lower.imag()},
          {rectangle.upper.real(), rectangle.upper.imag()}};
}

Entry to_entry(const Rectangle& rectangle, std::size_t number) {
  const auto& [lower, upper] = rectangle;
  require(std::isfinite(std::abs(lower)) && std::isfinite(std::abs(upper)), "rectangle ", number,
          " has a corner that is not finite: ", lower, " and ", upper);
  return {to_box(rectangle), number};
}

}  // namespace

struct RectangleIndex::Tree {
  geometry::index::rtree<Entry, geometry::index::quadratic<16>> entries;
};

Rectangle square_about(Complex centre, double radius) {
  return widened({centre, centre}, radius);
}

Rectangle widened(const Rectangle& rectangle, double distance) {
  const Complex diagonal{distance, distance};
  return {rectangle.lower - diagonal, rectangle.upper + diagonal};
}

Rectangle bounding_rectangle(const Eigen::Ref<const ComplexVector>& points) {
  return {{points.real().minCoeff(), points.imag().minCoeff()},
          {points.real().maxCoeff(), points.imag().maxCoeff()}};
}

RectangleIndex::RectangleIndex(const std::vector<Rectangle>& rectangles) {
  std::vector<Entry> entries;
  for (const Rectangle& rectangle : rectangles) {
    entries.push_back(to_entry(rectangle, entries.size()));
  }
  tree_.reset(new Tree{decltype(Tree::entries)(entries)});
}

RectangleIndex::~RectangleIndex() = default;

void RectangleIndex::insert(const Rectangle& rectangle) {
  tree_->entries.insert(to_entry(rectangle, tree_->entries.size()));
}

std::vector<std::size_t> RectangleIndex::meeting(const Rectangle& rectangle) const {
  std::vector<std::size_t> numbers;
  tree_->entries.query(geometry::index::intersects(to_box(rectangle)),
                       boost::make_function_output_iterator(
                           [&](const Entry& entry) { numbers.push_back(entry.second); }));
  std::ranges::sort(numbers);
  return numbers;
}

}  // namespace stokesbook
