// Checks the tree of components: groups, their order, and the disks about them.
#include "preconditioning/component_tree.hpp"

#include <algorithm>
#include <cmath>

#include <boost/test/unit_test.hpp>

namespace stokesbook::test {

using Eigen::Index;

namespace {

// Returns disks of various sizes along a spiral.
std::vector<Box> spiral(Index count) {
  std::vector<Box> disks(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const auto turn = static_cast<double>(k);
    disks[k].centre = std::polar(std::sqrt(turn), 2.4 * turn) + Complex(3.0, -2.0);
    disks[k].radius = 0.1 + 0.05 * std::sin(turn);
  }
  return disks;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(component_tree)

BOOST_AUTO_TEST_CASE(every_component_is_in_one_group_of_each_level) {
  for (const Index count : {1, 2, 3, 4, 5, 16, 17, 100}) {
    const std::vector<Box> disks = spiral(count);
    const ComponentTree tree(disks);
    std::vector<Index> sorted = tree.order;
    std::ranges::sort(sorted);
    for (Index k = 0; k < count; ++k) BOOST_TEST(sorted[static_cast<std::size_t>(k)] == k);
    BOOST_TEST(tree.levels.front().size() == disks.size());
    BOOST_TEST(tree.levels.back().size() == 1u);
    for (const std::vector<Box>& level : tree.levels) {
      Index next = 0;
      for (const Box& group : level) {
        BOOST_TEST(group.first == next);
        BOOST_TEST(group.last > group.first);
        next = group.last;
      }
      BOOST_TEST(next == count);
    }
  }
}

BOOST_AUTO_TEST_CASE(groups_consist_of_at_most_four_children_and_their_disks_contain_them) {
  const ComponentTree tree(spiral(100));
  BOOST_TEST(tree.levels.size() == 5u);
  for (std::size_t l = 1; l < tree.levels.size(); ++l) {
    const std::vector<Box>&below = tree.levels[l - 1], &groups = tree.levels[l];
    Index next = 0;
    for (const Box& group : groups) {
      BOOST_TEST(group.first_child == next);
      BOOST_TEST(group.last_child > group.first_child);
      BOOST_TEST(group.last_child <= group.first_child + 4);
      BOOST_TEST(below[static_cast<std::size_t>(group.first_child)].first == group.first);
      BOOST_TEST(below[static_cast<std::size_t>(group.last_child - 1)].last == group.last);
      for (Index c = group.first_child; c < group.last_child; ++c) {
        const Box& child = below[static_cast<std::size_t>(c)];
        BOOST_TEST(std::abs(child.centre - group.centre) + child.radius <=
                   group.radius * (1.0 + 1e-14));
      }
      next = group.last_child;
    }
    BOOST_TEST(next == static_cast<Index>(below.size()));
  }
}

BOOST_AUTO_TEST_CASE(groups_are_compact) {
  // All groups of 256 places on a square lattice are squares.
  std::vector<Box> disks;
  for (int i = 0; i < 256; ++i) {
    Box disk;
    disk.centre = Complex(i % 16, i / 16);
    disks.push_back(disk);
  }
  const ComponentTree tree(disks);
  for (std::size_t l = 1; l < tree.levels.size(); ++l) {
    const double side = std::ldexp(1.0, static_cast<int>(l)) - 1.0;
    for (const Box& group : tree.levels[l]) {
      BOOST_TEST(std::abs(group.radius - side / std::sqrt(2.0)) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
