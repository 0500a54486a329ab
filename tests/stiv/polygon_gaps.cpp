// Checks the test that accepts a state: gaps of polygons that are apart, and depths of polygons
// that overlap in different ways.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

std::vector<PolygonGap> gaps(const ContactShapes& shapes, const std::vector<Pose>& poses,
                             double reach = 0.5) {
  return polygon_gaps(shapes, poses, reach);
}

}  // namespace

BOOST_AUTO_TEST_CASE(circles_apart_and_overlapping) {
  const auto circle = body(Circle{1.0}, 128);
  for (double gap : {0.4, 0.1, 1e-6, 0.0, -1e-3, -0.3}) {
    for (double turn : {0.0, 0.4, 2.0}) {
      const Complex apart = std::polar(2.0 + gap, turn);
      const auto found =
          gaps({circle, circle}, {{{5.0, 3.0}, turn}, {apart + Complex{5.0, 3.0}, turn}});
      BOOST_REQUIRE(found.size() == 1u);
      BOOST_TEST(found[0].a == 0u);
      BOOST_TEST(found[0].b == 1u);
      BOOST_TEST(std::abs(found[0].gap - gap) < 2.0 * circle->sag);
      BOOST_TEST(std::abs(std::abs(found[0].point - Complex{5.0, 3.0} - 0.5 * apart) -
                          0.5 * std::abs(gap)) < 0.05);
    }
  }
  BOOST_TEST(gaps({circle, circle}, {{{0.0, 0.0}, 0.0}, {{2.6, 0.0}, 0.0}}).empty());
}

// The point of a gap is a vertex of one of the two bodies, also if both have turned.
BOOST_AUTO_TEST_CASE(points_of_gaps_turn_with_their_bodies) {
  const auto ellipse = body(Ellipse{2.0, 0.5}, 128);
  for (const double turn : {0.0, 0.7, 2.5}) {
    const std::vector<Pose> poses{
        {{5.0, 3.0}, turn},
        {Complex{5.0, 3.0} + std::polar(1.0, turn) * Complex{2.0, 1.3}, turn + 0.5}};
    const auto found = gaps({ellipse, ellipse}, poses);
    BOOST_REQUIRE(found.size() == 1u);
    double least = 10.0;  // distance of the point from a vertex
    for (const Pose& pose : poses) {
      for (Eigen::Index i = 0; i < ellipse->polygon.size(); ++i) {
        const Complex vertex =
            pose.position + std::polar(1.0, pose.orientation) * ellipse->polygon.vertex(i);
        least = std::min(least, std::abs(found[0].point - vertex));
      }
    }
    BOOST_TEST(least < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_body_in_a_body) {
  const auto large = body(Circle{1.0}, 128), small = body(Circle{0.2}, 64);
  for (Complex place : {Complex{0.0, 0.0}, {0.3, 0.4}, {0.75, 0.0}}) {
    const auto found = gaps({large, small}, {{{0.0, 0.0}, 0.0}, {place, 0.0}}, 0.05);
    BOOST_REQUIRE(found.size() == 1u);
    BOOST_TEST(found[0].gap < -0.2);
    // The depth is that of the small body's farthest vertex.
    BOOST_TEST(std::abs(found[0].gap + (1.0 - std::max(0.0, std::abs(place) - 0.2))) < 0.21);
  }
}

BOOST_AUTO_TEST_CASE(a_body_and_its_container) {
  const auto wall = container(Circle{2.0}, 256), disk = body(Circle{0.5}, 64);
  const auto at = [&](Complex place) {
    return gaps({disk, wall}, {{place, 0.0}, {{0.0, 0.0}, 0.3}}, 0.3);
  };
  BOOST_TEST(at({0.0, 0.0}).empty());
  BOOST_REQUIRE(at({1.3, 0.0}).size() == 1u);
  BOOST_TEST(std::abs(at({1.3, 0.0})[0].gap - 0.2) < 1e-3);
  BOOST_TEST(std::abs(at({1.7, 0.0})[0].gap + 0.2) < 1e-3);  // through the wall
  BOOST_TEST(std::abs(at({0.0, 2.6})[0].gap + 1.1) < 1e-3);  // outside
  BOOST_TEST(std::abs(at({0.0, 90.0})[0].gap + 88.5) < 1e-3);
}

// Thin rods cross each other: none of the rods' few vertices lies in the other rod.
BOOST_AUTO_TEST_CASE(edges_that_cross_without_a_vertex_inside) {
  const auto rod = body(Ellipse{1.0, 0.02}, 6);
  const auto found =
      gaps({rod, rod}, {{{0.0, 0.0}, 0.0}, {{0.0, 0.0}, 0.5 * std::numbers::pi}}, 0.01);
  BOOST_REQUIRE(found.size() == 1u);
  BOOST_TEST(found[0].gap <= 0.0);
}

// A comparison of all pairs of vertices and edges finds the same gaps, and no others.
BOOST_AUTO_TEST_CASE(all_pairs_of_a_crowd) {
  std::size_t overlaps = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Step step = random_step(12, seed, 0.5, seed % 2 == 0);
    std::vector<Pose> poses;
    for (const RigidPath& path : step.paths) poses.push_back(path.at(1.0));
    const auto found = gaps(step.shapes, poses, 0.2);
    std::size_t count = 0;
    for (std::size_t b = 0; b < poses.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        double least = INFINITY;
        for (const auto& [p, q] : {std::pair{a, b}, {b, a}}) {
          for (Complex x : step.shapes[p]->polygon.vertices()) {
            const Complex place = poses[p].position + std::polar(1.0, poses[p].orientation) * x;
            const Complex local =
                (place - poses[q].position) * std::polar(1.0, -poses[q].orientation);
            least = std::min(least, step.shapes[q]->polygon.closest(local, INFINITY).distance);
          }
        }
        const auto same = std::ranges::find_if(
            found, [&](const PolygonGap& gap) { return gap.a == a && gap.b == b; });
        BOOST_TEST((same != found.end()) == (least < 0.2));
        if (same == found.end()) continue;
        BOOST_TEST(std::abs(same->gap - least) < 1e-13);
        ++count;
        if (least < 0.0) ++overlaps;
      }
    }
    BOOST_TEST(found.size() == count);
  }
  BOOST_TEST(overlaps > 4u);
}

BOOST_AUTO_TEST_CASE(bad_poses_are_refused) {
  const auto circle = body(Circle{1.0}, 16);
  BOOST_CHECK_THROW(gaps({circle, circle}, {{{0.0, 0.0}, 0.0}}), std::invalid_argument);
  BOOST_CHECK_THROW(gaps({circle, circle}, {{{0.0, 0.0}, 0.0}, {{std::nan(""), 0.0}, 0.0}}),
                    std::invalid_argument);
}
