// Checks that every pair of target and source is in one interaction, and that far boxes fulfil
// (08.8).
#include "fmm/interactions.hpp"

#include <algorithm>

#include <boost/test/unit_test.hpp>

#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

// Counts how often each pair of points is summed. The rows of the result are the targets, and the
// columns are the sources, in the order of the trees.
Eigen::MatrixXi counts(const Quadtree& targets, const Quadtree& sources,
                       const Interactions& interactions) {
  Eigen::MatrixXi count = Eigen::MatrixXi::Zero(targets.size(), sources.size());
  for (std::size_t t = 0; t < targets.boxes.size(); ++t) {
    const Box& target = targets.boxes[t];
    const auto add = [&](Index first, Index last) {
      count.block(target.first, first, target.size(), last - first).array() += 1;
    };
    for (const Index s : interactions.far[t]) {
      const Box& source = sources.boxes[static_cast<std::size_t>(s)];
      add(source.first, source.last);
      const double distance = std::abs(target.centre - source.centre - interactions.shift);
      BOOST_TEST_REQUIRE(source.radius < 0.5 * (distance - target.radius) * (1.0 + 1e-14));
      BOOST_TEST_REQUIRE(target.radius < 0.5 * (distance - source.radius) * (1.0 + 1e-14));
    }
    const std::vector<Range>& near = interactions.near[t];
    for (std::size_t i = 0; i < near.size(); ++i) {
      add(near[i].first, near[i].last);
      if (i > 0) BOOST_TEST_REQUIRE(near[i].first > near[i - 1].last);
    }
    BOOST_TEST_REQUIRE((near.empty() || target.is_leaf()));
  }
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_pair_once) {
  for (const test::PointSet& set : test::point_sets(400)) {
    BOOST_TEST_CONTEXT(set.name) {
      for (const Index leaf_size : {1, 10, 50}) {
        for (const Index direct_pairs : {0, 100}) {
          const Quadtree tree(set.points, Eigen::VectorXd::Constant(400, 1e-3), leaf_size);
          const Quadtree others(2.0 * test::random_vector(200, 3), {}, 2 * leaf_size);
          for (const Quadtree* targets : {&tree, &others}) {
            for (const Quadtree* sources : {&tree, &others}) {
              for (const Complex shift : {Complex{}, Complex{1.0, -0.3}}) {
                const Interactions found =
                    find_interactions(*targets, *sources, direct_pairs, shift);
                BOOST_TEST(found.shift == shift);
                BOOST_TEST((counts(*targets, *sources, found).array() == 1).all());
              }
            }
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(few_interactions_in_a_square) {
  const Index n = 20000;
  const Quadtree tree(test::random_vector(n, 1), {}, 40);
  const Interactions found = find_interactions(tree, tree, 0);
  std::size_t far = 0;
  for (const std::vector<Index>& list : found.far) far += list.size();
  BOOST_TEST(far < 30 * tree.boxes.size());
}

BOOST_AUTO_TEST_CASE(no_points) {
  const Quadtree empty({}, {}, 5), tree(test::random_vector(9, 1), {}, 5);
  BOOST_TEST(find_interactions(empty, tree, 0).near.empty());
  const Interactions without_sources = find_interactions(tree, empty, 0);
  for (std::size_t b = 0; b < tree.boxes.size(); ++b) {
    BOOST_TEST(without_sources.far[b].empty());
    BOOST_TEST(without_sources.near[b].empty());
  }
}

// Margins exclude targets near a source from its expansion, even where boxes are single points.
BOOST_AUTO_TEST_CASE(no_target_within_a_margin_is_far) {
  const ComplexVector sources = test::random_vector(200, 1);
  const Eigen::VectorXd margins = 0.3 * test::random_vector(200, 2).real().cwiseAbs();
  const Quadtree source_tree(sources, margins, 1), target_tree(test::random_vector(200, 3), {}, 1);
  const Interactions found = find_interactions(target_tree, source_tree, 0);
  Index far_pairs = 0;
  for (std::size_t t = 0; t < target_tree.boxes.size(); ++t) {
    const Box& target = target_tree.boxes[t];
    for (const Index s : found.far[t]) {
      const Box& source = source_tree.boxes[static_cast<std::size_t>(s)];
      for (Index i = target.first; i < target.last; ++i) {
        for (Index j = source.first; j < source.last; ++j) {
          const Complex r{target_tree.x[i] - source_tree.x[j], target_tree.y[i] - source_tree.y[j]};
          const Index node = source_tree.order[static_cast<std::size_t>(j)];
          BOOST_TEST_REQUIRE(std::abs(r) > margins[node]);
          ++far_pairs;
        }
      }
    }
  }
  BOOST_TEST(far_pairs > 1000);
}
