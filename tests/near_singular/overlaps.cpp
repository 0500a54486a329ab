// Checks that curves that cross, contain one another, or leave their container are reported as
// overlaps, and that curves at any positive distance are not.
#include <cmath>
#include <numbers>
#include <random>

#include <boost/test/unit_test.hpp>

#include "support/smooth_curve.hpp"

using namespace stokesbook;
using test::smooth_body;
using test::smooth_curve;

namespace {

double gap(const SmoothCurve& a, const SmoothCurve& b) {
  const double forth = closest_points(a, b).gap, back = closest_points(b, a).gap;
  BOOST_TEST((forth > 0.0) == (back > 0.0));
  return forth;
}

// Returns whether a fine node of one body lies within the other body's polygon of fine nodes.
bool nodes_overlap(const SmoothCurve& a, const SmoothCurve& b) {
  constexpr Eigen::Index n = 250;
  const auto holds = [](const ComplexVector& polygon, Complex point) {
    double angle = 0.0;
    for (Eigen::Index j = 0; j < n; ++j) {
      angle += std::arg((polygon[(j + 1) % n] - point) / (polygon[j] - point));
    }
    return std::abs(angle) > std::numbers::pi;
  };
  const ComplexVector x_a = resample(a.nodes.x, n), x_b = resample(b.nodes.x, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    if (holds(x_a, x_b[j]) || holds(x_b, x_a[j])) return true;
  }
  return false;
}

class RandomAngles {
 public:
  double operator()() { return uniform_(generator_); }

 private:
  std::mt19937 generator_{3};
  std::uniform_real_distribution<double> uniform_{0.0, 2.0 * std::numbers::pi};
};

}  // namespace

BOOST_AUTO_TEST_CASE(circles_that_cross_by_any_depth) {
  RandomAngles angle;
  for (double depth : {0.5, 1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
    for (int trial = 0; trial < 20; ++trial) {
      const SmoothCurve a = smooth_body(Circle{1.0}, 64, {}, angle());
      const Complex place = std::polar(1.7 - depth, angle());
      const SmoothCurve b = smooth_body(Circle{0.7}, 48, place, angle());
      BOOST_TEST(gap(a, b) <= 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_depth_of_an_overlap) {
  for (double depth : {0.3, 0.1, 0.03}) {
    const SmoothCurve a = smooth_body(Circle{1.0}, 256, {}, 0.1);
    const SmoothCurve b = smooth_body(Circle{1.0}, 256, 2.0 - depth, 0.2);
    BOOST_TEST(std::abs(-gap(a, b) - depth) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_body_inside_another) {
  for (Complex position : {Complex{0.0, 0.0}, Complex{0.5, 0.1}, Complex{0.0, 0.699}}) {
    const SmoothCurve large = smooth_body(Circle{1.0}, 64, {}, 0.3);
    BOOST_TEST(gap(large, smooth_body(Circle{0.3}, 32, position, 0.0)) <= 0.0);
    BOOST_TEST(gap(large, smooth_body(Star{0.25, 0.1, 5}, 64, position, 1.0)) <= 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_same_place_twice) {
  const SmoothCurve body = smooth_body(Ellipse{1.0, 0.4}, 32, {0.2, 0.3}, 0.7);
  BOOST_TEST(gap(body, body) <= 0.0);
}

BOOST_AUTO_TEST_CASE(a_cross_of_slender_bodies_whose_tips_are_in_the_fluid) {
  const SmoothCurve a = smooth_body(Ellipse{1.0, 0.1}, 96, {}, 0.0);
  for (double angle : {0.2, 1.0, 1.5}) {
    BOOST_TEST(gap(a, smooth_body(Ellipse{1.0, 0.1}, 96, {0.1, 0.05}, angle)) <= 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_body_outside_its_container_or_across_it) {
  const SmoothCurve container = smooth_curve(Ellipse{3.0, 2.0}, 128, Side::fluid_inside, {}, 0.0);
  for (Complex position : {Complex{3.51, 0.0}, Complex{0.0, 7.0}, Complex{3.0, 0.0},
                           Complex{0.0, 1.6}, Complex{0.0, 1.5 + 1e-6}}) {
    BOOST_TEST(gap(container, smooth_body(Circle{0.5}, 32, position, 0.0)) <= 0.0);
  }
  BOOST_TEST(gap(container, smooth_body(Circle{0.5}, 32, {0.0, 1.5 - 1e-6}, 0.0)) > 0.0);
  // The container lies within the body that it should contain.
  BOOST_TEST(gap(container, smooth_body(Circle{9.0}, 64, {}, 0.0)) <= 0.0);
}

BOOST_AUTO_TEST_CASE(near_contacts_are_no_overlaps_wherever_the_nodes_are) {
  // The gaps are far below the node spacing, so that neither the tangents at the nodes nor the
  // polygons of nodes decide.
  RandomAngles angle;
  for (double distance : {1e-3, 1e-5, 1e-8}) {
    for (int trial = 0; trial < 100; ++trial) {
      const double direction = angle();
      const Complex beside = std::polar(1.5 + distance, direction);
      const SmoothCurve body = smooth_body(Circle{1.0}, 32, {}, angle());
      BOOST_TEST(gap(body, smooth_body(Circle{0.5}, 32, beside, angle())) > 0.0);
      const SmoothCurve container = smooth_curve(Circle{2.0}, 32, Side::fluid_inside, {}, angle());
      const Complex within = std::polar(1.5 - distance, direction);
      BOOST_TEST(gap(container, smooth_body(Circle{0.5}, 32, within, angle())) > 0.0);
      BOOST_TEST(gap(container, smooth_body(Circle{0.5}, 32, within, direction)) > 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_disk_in_the_valley_of_a_star_is_no_overlap) {
  // The disk nearly touches the bottom of the valley, r = 1 - A along t = pi / k, with a node or
  // with a point between nodes.
  const SmoothCurve star = smooth_body(Star{1.0, 0.2, 3}, 64, {}, 0.0);
  const Complex valley = std::polar(1.0, std::numbers::pi / 3.0);
  for (double distance : {1e-3, 1e-5, 1e-8}) {
    for (double orientation : {0.0, 0.05, std::numbers::pi / 3.0, 4.0 * std::numbers::pi / 3.0}) {
      const SmoothCurve disk = smooth_body(Circle{0.2}, 32, (1.0 + distance) * valley, orientation);
      BOOST_TEST(gap(star, disk) > 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(random_placements_of_lobed_and_slender_bodies) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double turn = 2.0 * std::numbers::pi;
  int overlaps = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Shape star = Star{0.7, 0.3 * uniform(generator), 2 + trial % 5};
    const Shape slender = Ellipse{1.0, 0.1 + 0.2 * uniform(generator)};
    const SmoothCurve a = smooth_body(star, 128, {}, turn * uniform(generator));
    const Complex direction = std::polar(1.0, turn * uniform(generator));
    const Complex place = 2.0 * uniform(generator) * direction;
    const SmoothCurve b =
        smooth_body(trial % 2 == 0 ? star : slender, 128, place, turn * uniform(generator));
    const bool overlap = nodes_overlap(a, b);
    BOOST_TEST((gap(a, b) <= 0.0) == overlap);
    overlaps += overlap ? 1 : 0;
  }
  BOOST_TEST(overlaps > 50);
  BOOST_TEST(overlaps < 130);
}
