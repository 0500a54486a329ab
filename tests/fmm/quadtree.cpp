// Checks that every point is in one leaf, and that every box holds its points with their margins,
// wherever the points lie.
#include "fmm/quadtree.hpp"

#include <limits>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

void check_tree(const ComplexVector& points, const Eigen::VectorXd& margins, Index leaf_size) {
  const Quadtree tree(points, margins, leaf_size);
  std::vector<int> in_leaves(static_cast<std::size_t>(points.size()), 0);
  for (std::size_t b = 0; b < tree.boxes.size(); ++b) {
    const Box& box = tree.boxes[b];
    BOOST_TEST_REQUIRE(box.size() >= 1);
    double reach = 0.0;
    for (Index i = box.first; i < box.last; ++i) {
      const Index point = tree.order[static_cast<std::size_t>(i)];
      BOOST_TEST_REQUIRE((Complex{tree.x[i], tree.y[i]} == points[point]));
      const double margin = margins.size() == 0 ? 0.0 : margins[point];
      reach = std::max(reach, std::abs(points[point] - box.centre) + margin);
      if (box.is_leaf()) ++in_leaves[static_cast<std::size_t>(point)];
    }
    BOOST_TEST(box.radius >= reach * (1.0 - 1e-15));
    BOOST_TEST(box.radius <= reach * (1.0 + 1e-15) + 1e-100);
    Index next = box.first;
    for (Index c = box.first_child; c < box.last_child; ++c) {
      const Box& child = tree.boxes[static_cast<std::size_t>(c)];
      BOOST_TEST(child.parent == static_cast<Index>(b));
      BOOST_TEST(child.first == next);
      next = child.last;
    }
    if (!box.is_leaf()) {
      BOOST_TEST(next == box.last);
      BOOST_TEST(box.last_child - box.first_child >= 2);
    }
  }
  for (const int count : in_leaves) BOOST_TEST_REQUIRE(count == 1);
  BOOST_TEST(tree.levels.back() == static_cast<Index>(tree.boxes.size()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(trees_hold_their_points) {
  for (const test::PointSet& set : test::point_sets(700)) {
    BOOST_TEST_CONTEXT(set.name) {
      const Eigen::VectorXd margins = 0.1 * test::random_vector(700, 8).real().cwiseAbs();
      for (const Index leaf_size : {1, 7, 40, 699, 700}) {
        check_tree(set.points, {}, leaf_size);
        check_tree(set.points, margins, leaf_size);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(leaves_are_small) {
  const Quadtree tree(test::random_vector(1000, 1), {}, 10);
  for (const Box& box : tree.boxes) BOOST_TEST((box.size() <= 10 || !box.is_leaf()));
}

BOOST_AUTO_TEST_CASE(few_points_and_points_that_no_number_lies_between) {
  const Quadtree empty({}, {}, 5);
  BOOST_TEST(empty.boxes.empty());
  BOOST_TEST((empty.levels == std::vector<Index>{0}));
  check_tree(ComplexVector::Constant(1, {2.0, 3.0}), {}, 1);
  const double next = std::nextafter(1.0, 2.0);
  check_tree(ComplexVector{{Complex{1.0, 0.0}, Complex{next, 0.0}, Complex{next, 0.0}}}, {}, 1);
  check_tree(ComplexVector{{Complex{next, 0.0}, Complex{std::nextafter(next, 2.0), 0.0}}}, {}, 1);
  // The tree is as deep as floating-point numbers permit.
  ComplexVector powers(600);
  for (Index i = 0; i < 600; ++i) powers[i] = std::ldexp(1.0, -static_cast<int>(i));
  check_tree(powers, {}, 1);
}

BOOST_AUTO_TEST_CASE(bad_points_are_refused) {
  const ComplexVector points = test::random_vector(3, 1);
  BOOST_CHECK_THROW(Quadtree(points, {}, 0), std::invalid_argument);
  BOOST_CHECK_THROW(Quadtree(points, Eigen::VectorXd::Zero(2), 5), std::invalid_argument);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const Complex bad :
       {Complex{not_a_number, 0.0}, Complex{0.0, not_a_number}, Complex{infinity, 0.0}}) {
    ComplexVector with_bad = points;
    with_bad[1] = bad;
    BOOST_CHECK_THROW(Quadtree(with_bad, {}, 5), std::invalid_argument);
  }
  BOOST_CHECK_THROW(Quadtree(points, Eigen::Vector3d{0.0, infinity, 0.0}, 5),
                    std::invalid_argument);
}
