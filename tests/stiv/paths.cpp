// Checks the paths of a step: relative places (10.2), and bounds of speed (10.4) and straying that
// hold and are nearly sharp. Compares the rectangles and pairs of the broad phase with a comparison
// of all components.
#include <cmath>
#include <numbers>
#include <random>

#include <boost/test/unit_test.hpp>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

class RandomPaths {
 public:
  explicit RandomPaths(unsigned seed) : generator_(seed) {}

  RigidPath operator()(double travel, double turn) {
    return {{vector(3.0), 3.0 * number()}, vector(travel), turn * number()};
  }

  Complex vector(double length) {
    const double x = number();
    return length * Complex{x, number()};
  }

 private:
  double number() { return uniform_(generator_); }

  std::mt19937 generator_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

Complex in_plane(const Pose& pose, Complex x) {
  return pose.position + std::polar(1.0, pose.orientation) * x;
}

}  // namespace

BOOST_AUTO_TEST_CASE(relative_places) {
  RandomPaths random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const RigidPath a = random(2.0, 4.0), b = random(2.0, 4.0);
    const RelativePath path(a, b);
    const Complex x = random.vector(1.0);
    for (double tau : {0.0, 0.37, 1.0}) {
      const RelativeFrame frame = path.at(tau);
      BOOST_TEST(std::abs(in_plane(b.at(tau), frame(x)) - in_plane(a.at(tau), x)) < 1e-14);
      BOOST_TEST(std::abs(frame.inverse(frame(x)) - x) < 1e-14);
    }
    BOOST_TEST(path.start()(x) == path.at(0.0)(x));
    BOOST_TEST(path.end()(x) == path.at(1.0)(x));
  }
}

BOOST_AUTO_TEST_CASE(bounds_of_speed_and_straying) {
  RandomPaths random(2);
  double tightest_speed = 0.0, tightest_stray = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    const double travel = trial % 4 == 0 ? 0.0 : 2.0, turn = trial % 3 == 0 ? 0.0 : 1.5;
    const RelativePath path(random(travel, turn), random(2.0, trial % 5 == 0 ? 0.0 : 1.5));
    const Complex x = random.vector(1.0);
    constexpr double h = 1e-5, step = 0.2;
    for (double tau = h; tau < 1.0 - step; tau += 0.05) {
      const double speed = std::abs(path.at(tau + h)(x) - path.at(tau - h)(x)) / (2.0 * h);
      BOOST_TEST(speed <= path.speed_bound(std::abs(x)) * (1.0 + 1e-9) + 1e-9);
      const Complex from = path.at(tau)(x), to = path.at(tau + step)(x);
      const Complex chord_point = 0.5 * (from + to);
      const double stray = std::abs(path.at(tau + 0.5 * step)(x) - chord_point);
      BOOST_TEST(stray <= path.stray_bound(std::abs(x), step) + 1e-14);
      tightest_speed = std::max(tightest_speed, speed / path.speed_bound(std::abs(x)));
      if (stray > 1e-6) {
        tightest_stray = std::max(tightest_stray, stray / path.stray_bound(std::abs(x), step));
      }
    }
  }
  BOOST_TEST(tightest_speed > 0.99);
  BOOST_TEST(tightest_stray > 0.9);
}

// Checks each term of the straying alone: an observer that turns, an observer whom the body passes,
// and a body that turns.
BOOST_AUTO_TEST_CASE(each_cause_of_straying) {
  const Complex x{0.3, 0.1};
  const auto ratio = [&](const RigidPath& a, const RigidPath& b) {
    const RelativePath path(a, b);
    constexpr double step = 0.02;
    const Complex middle = 0.5 * (path.at(0.0)(x) + path.at(step)(x));
    return std::abs(path.at(0.5 * step)(x) - middle) / path.stray_bound(std::abs(x), step);
  };
  const RigidPath held{};
  const auto is_tight = [](double value) { return value > 0.95 && value < 1.0 + 1e-6; };
  BOOST_TEST(is_tight(ratio({{{0.0, 0.0}, 0.4}, {0.0, 0.0}, 0.7}, held)));
  BOOST_TEST(is_tight(ratio({{{50.0, 0.0}, 0.4}, {0.0, 0.0}, 0.0}, {{}, {0.0, 0.0}, 0.3})));
  BOOST_TEST(is_tight(ratio({{}, {90.0, 0.0}, 0.01}, {{}, {0.0, 0.0}, 0.01})));
}

BOOST_AUTO_TEST_CASE(swept_rectangles_hold_all_places) {
  RandomPaths random(3);
  const auto shape = body(Ellipse{1.0, 0.1}, 64);
  for (int trial = 0; trial < 60; ++trial) {
    const RigidPath path = random(2.0, trial % 2 == 0 ? 1.0 : 7.0);
    const Rectangle swept = swept_rectangle(*shape, path);
    Rectangle seen = bounding_rectangle(*shape, path.at(0.0));
    for (int i = 0; i <= 200; ++i) {
      const Rectangle at = bounding_rectangle(*shape, path.at(i / 200.0));
      seen = {{std::min(seen.lower.real(), at.lower.real()),
               std::min(seen.lower.imag(), at.lower.imag())},
              {std::max(seen.upper.real(), at.upper.real()),
               std::max(seen.upper.imag(), at.upper.imag())}};
    }
    BOOST_TEST(swept.lower.real() <= seen.lower.real() + 1e-12);
    BOOST_TEST(swept.lower.imag() <= seen.lower.imag() + 1e-12);
    BOOST_TEST(swept.upper.real() >= seen.upper.real() - 1e-12);
    BOOST_TEST(swept.upper.imag() >= seen.upper.imag() - 1e-12);
    // The turn enlarges the rectangle by little more than necessary.
    if (std::abs(path.rotation) < 1.0) {
      BOOST_TEST(swept.upper.real() < seen.upper.real() + 0.13 * shape->radius);
    }
  }
}

BOOST_AUTO_TEST_CASE(near_pairs_are_those_of_all) {
  const Step step = random_step(30, 5, 0.3, true);
  std::vector<Rectangle> swept;
  for (std::size_t k = 0; k < step.shapes.size(); ++k) {
    swept.push_back(swept_rectangle(*step.shapes[k], step.paths[k]));
  }
  for (double reach : {0.0, 0.1, 0.5}) {
    std::vector<ComponentPair> expected;
    for (std::size_t a = 0; a < swept.size(); ++a) {
      for (std::size_t b = a + 1; b < swept.size(); ++b) {
        const Rectangle &p = swept[a], &q = swept[b];
        const bool is_near =
            p.lower.real() - reach <= q.upper.real() && q.lower.real() - reach <= p.upper.real() &&
            p.lower.imag() - reach <= q.upper.imag() && q.lower.imag() - reach <= p.upper.imag();
        if (a == 0 || is_near) expected.emplace_back(a, b);  // component 0 is the container
      }
    }
    BOOST_TEST((near_pairs(step.shapes, swept, reach) == expected));
    BOOST_TEST(expected.size() < 200u);
  }
}
