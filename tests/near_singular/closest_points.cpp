// Checks the least distance of two curves for any places of their nodes. Gaps of circles are exact
// to rounding, and gaps of other shapes are compared with a search.
#include <cmath>
#include <numbers>
#include <random>

#include <boost/test/unit_test.hpp>

#include "support/smooth_curve.hpp"
#include "trapezoid/grading.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::smooth_body;
using test::smooth_curve;

namespace {

constexpr double golden = std::numbers::phi - 1.0;

// Returns the minimum of a function of one variable with a single minimum in [low, high].
template <class Function>
double golden_minimum(const Function& f, double low, double high) {
  while (high - low > 1e-9) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (f(left) < f(right) ? high : low) = f(left) < f(right) ? right : left;
  }
  return f(0.5 * (low + high));
}

// Searches the gap by brute force: compares all pairs of fine nodes, then refines the search near
// the best pair.
double searched_gap(const SmoothCurve& a, const SmoothCurve& b) {
  constexpr int n = 720;
  constexpr double step = 2.0 * std::numbers::pi / n;
  double best = 1e300, s = 0.0, t = 0.0;
  ComplexVector at_b(n);
  for (int j = 0; j < n; ++j) at_b[j] = b.at(step * j).value;
  for (int i = 0; i < n; ++i) {
    Index j = 0;
    const double distance = (at_b.array() - a.at(step * i).value).abs().minCoeff(&j);
    if (distance < best) best = distance, s = step * i, t = step * static_cast<double>(j);
  }
  const auto to_b = [&](double s_a) {
    const Complex x = a.at(s_a).value;
    return golden_minimum([&](double t_b) { return std::abs(b.at(t_b).value - x); }, t - 3.0 * step,
                          t + 3.0 * step);
  };
  return golden_minimum(to_b, s - 2.0 * step, s + 2.0 * step);
}

// Checks the properties of any closest pair: the points lie on their curves at the parameters, and
// the gap lies between the points, along both normals.
void check_consistency(const SmoothCurve& a, const SmoothCurve& b, const ClosestPoints& closest) {
  BOOST_TEST(std::abs(a.at(closest.parameter_a).value - closest.point_a) < 1e-13);
  BOOST_TEST(std::abs(b.at(closest.parameter_b).value - closest.point_b) < 1e-13);
  const Complex across = closest.point_b - closest.point_a;
  BOOST_TEST(std::abs(std::abs(across) - closest.gap) < 1e-15);
  const auto slope = [&](const SmoothCurve& curve, double t) {
    const Complex tangent = curve.at(t).first;
    return std::abs(dot(across, tangent)) / std::abs(tangent);
  };
  BOOST_TEST(slope(a, closest.parameter_a) < 1e-12);
  BOOST_TEST(slope(b, closest.parameter_b) < 1e-12);
}

}  // namespace

// The points lie on normals; the first guesses are up to eight steps away.
BOOST_AUTO_TEST_CASE(feet_of_perpendiculars) {
  constexpr double step = 2.0 * std::numbers::pi / 64.0;
  const Parametrisation ellipse = parametrisation(Ellipse{2.0, 1.0});
  for (double t : {0.0, 0.4, 1.5, 4.0}) {
    const auto at = ellipse(t);
    for (double distance : {0.0, 1e-9, 0.3, -0.3, 5.0}) {
      const Complex point = at.value - imaginary * distance * at.first / std::abs(at.first);
      for (double steps : {0.0, 1.0, -8.0}) {
        const Foot foot = find_foot(ellipse, point, t + steps * step, step);
        BOOST_TEST(std::abs(foot.parameter - t) < 1e-13);
        BOOST_TEST(std::abs(foot.at.value - at.value) < 1e-13);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(circles_at_any_gap_with_nodes_anywhere) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * std::numbers::pi);
  for (double gap : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
    for (int trial = 0; trial < 40; ++trial) {
      const double direction = angle(generator);
      const SmoothCurve a = smooth_body(Circle{1.0}, 64, {0.3, -0.2}, angle(generator));
      const SmoothCurve b = smooth_body(
          Circle{0.5}, 48, Complex{0.3, -0.2} + std::polar(1.5 + gap, direction), angle(generator));
      const ClosestPoints closest = closest_points(a, b);
      BOOST_TEST(std::abs(closest.gap - gap) < 1e-14);
      check_consistency(a, b, closest);
      const Complex expected = Complex{0.3, -0.2} + std::polar(1.0, direction);
      BOOST_TEST(std::abs(closest.point_a - expected) < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_circle_in_a_circular_container) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * std::numbers::pi);
  for (double gap : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
    for (int trial = 0; trial < 40; ++trial) {
      // In half of the trials the nearest point of the body is a node.
      const double direction = angle(generator);
      const double orientation = trial % 2 == 0 ? direction : angle(generator);
      const SmoothCurve container =
          smooth_curve(Circle{3.0}, 96, Side::fluid_inside, {1.0, 1.0}, angle(generator));
      const SmoothCurve body = smooth_body(
          Circle{0.5}, 32, Complex{1.0, 1.0} + std::polar(2.5 - gap, direction), orientation);
      const ClosestPoints closest = closest_points(body, container);
      BOOST_TEST(std::abs(closest.gap - gap) < 5e-14);
      check_consistency(body, container, closest);
    }
  }
}

BOOST_AUTO_TEST_CASE(other_shapes_against_a_search) {
  const Shape slender = Ellipse{1.0, 0.1}, round = Ellipse{0.8, 0.5}, star = Star{1.0, 0.3, 5};
  const std::vector<std::pair<SmoothCurve, SmoothCurve>> pairs = {
      // The ellipses lie tip to flank, flank to flank, and oblique.
      {smooth_body(slender, 96, {0.0, 0.0}, 0.0), smooth_body(slender, 96, {1.13, 0.2}, 1.5)},
      {smooth_body(slender, 96, {0.0, 0.0}, 0.3), smooth_body(slender, 96, {-0.06, 0.21}, 0.31)},
      {smooth_body(round, 32, {-1.0, 0.4}, 2.0), smooth_body(slender, 64, {0.9, -0.2}, -0.4)},
      // A disk deep in a valley nearly touches both flanks. A tip faces a tip.
      {smooth_body(star, 128, {0.0, 0.0}, 0.1),
       smooth_body(Circle{0.25}, 32, std::polar(1.06, 0.73), 0.0)},
      {smooth_body(star, 128, {0.0, 0.0}, 0.0), smooth_body(star, 96, {2.61, 0.02}, 3.1)},
      // Bodies lie in containers. One of the containers has walls that bulge inward.
      {smooth_body(round, 32, {0.4, 0.1}, 0.5),
       smooth_curve(Ellipse{2.0, 1.0}, 64, Side::fluid_inside, {}, 0.2)},
      {smooth_curve(Star{2.0, 0.3, 5}, 160, Side::fluid_inside, {}, 0.0),
       smooth_body(round, 32, {0.55, 0.3}, 0.4)}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    BOOST_TEST_CONTEXT("pair " << i) {
      const auto& [a, b] = pairs[i];
      const ClosestPoints closest = closest_points(a, b);
      BOOST_TEST(closest.gap > 0.0);
      BOOST_TEST(std::abs(closest.gap - searched_gap(a, b)) < 1e-13);
      check_consistency(a, b, closest);
      BOOST_TEST(std::abs(closest_points(b, a).gap - closest.gap) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_closest_nodes_need_not_lie_at_the_closest_points) {
  // A disk lies between two flanks of a valley, a little nearer to one flank. Turning the disk's
  // nodes changes nothing.
  const SmoothCurve star = smooth_body(Star{1.0, 0.3, 5}, 128, {}, 0.1);
  const Complex centre = std::polar(1.06, 0.73);
  const double reference = closest_points(star, smooth_body(Circle{0.25}, 512, centre, 0.0)).gap;
  for (int k = 0; k < 40; ++k) {
    const SmoothCurve disk = smooth_body(Circle{0.25}, 24, centre, 0.005 * k);
    BOOST_TEST(std::abs(closest_points(star, disk).gap - reference) < 1e-14);
    BOOST_TEST(std::abs(closest_points(disk, star).gap - reference) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_rigid_motion_of_both_and_a_change_of_unit) {
  const auto gap = [](double scale, Complex shift, double turn) {
    const auto at = [&](Complex z) { return scale * (shift + std::polar(1.0, turn) * z); };
    return closest_points(smooth_body(Ellipse{scale, 0.4 * scale}, 64, at({0.0, 0.0}), turn),
                          smooth_body(Star{scale, 0.2, 3}, 64, at({2.0, 0.4}), turn + 0.3))
               .gap /
           scale;
  };
  const double reference = gap(1.0, 0.0, 0.0);
  BOOST_TEST(reference > 0.05);
  for (double scale : {1e-3, 1.0, 1e3}) {
    BOOST_TEST(std::abs(gap(scale, {3.0, -4.0}, 2.0) - reference) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(graded_circles_have_their_gap_to_rounding) {
  // The nodes crowd at the gap, at a place near the gap, and on the far side.
  for (double gap : {1e-1, 1e-4, 1e-8}) {
    const double width = std::sqrt(gap);
    for (double place : {0.0, 0.4 * width, 2.0}) {
      const auto circle = [&](Complex position, double orientation) {
        const Curve reference = sample(Circle{1.0}, 96, Side::fluid_outside, {{{place, width}}});
        return smooth_curve(reference, position, orientation);
      };
      const Complex along = std::polar(1.0, 0.35);
      const SmoothCurve a = circle(0.0, 0.35);
      const SmoothCurve b = circle((2.0 + gap) * along, 0.35 + std::numbers::pi);
      const ClosestPoints closest = closest_points(a, b);
      BOOST_TEST(std::abs(closest.gap - gap) < 5e-15);
      check_consistency(a, b, closest);
    }
  }
}

BOOST_AUTO_TEST_CASE(graded_stars_are_measured_from_where_their_nodes_are) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double turn = 2.0 * std::numbers::pi;
  int apart = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Star shape{0.7, 0.25, 3 + trial % 3};
    const double distance = 1.45 + 0.3 * uniform(generator);
    const Complex centre = std::polar(distance, turn * uniform(generator));
    const double turn_a = turn * uniform(generator), turn_b = turn * uniform(generator);
    const ClosestPoints even = closest_points(smooth_body(shape, 512, 0.0, turn_a),
                                              smooth_body(shape, 512, centre, turn_b));
    if (even.gap <= 0.0) continue;
    ++apart;
    const auto graded = [&](double crowded, Complex position, double orientation) {
      const Grading grading{{{crowded, 0.05}}};
      SmoothCurve curve = smooth_body(shape, 128, position, orientation);
      curve.nodes = place(sample(shape, 128, Side::fluid_outside, grading), position, orientation);
      curve.parameters = graded_parameters(grading, 128);
      return curve;
    };
    const ClosestPoints closest = closest_points(graded(even.parameter_a, 0.0, turn_a),
                                                 graded(even.parameter_b, centre, turn_b));
    BOOST_TEST(std::abs(closest.gap - even.gap) < 1e-13);
  }
  BOOST_TEST(apart > 30);
}

// Two arms of a star lie at a curved wall at almost equal distances, and the gap between the arms
// is hardly larger.
BOOST_AUTO_TEST_CASE(two_minima_that_hardly_differ) {
  const Star shape{0.4, 0.09, 3};
  const Circle wall{2.0};
  const double facing = std::numbers::pi / 3.0;
  for (double tilt : {1e-5, 1e-4, 1e-3}) {
    for (double way : {-1.0, 1.0}) {
      const double orientation = -facing + way * tilt;
      const auto gap = [&](Index n, Index m, bool from_wall) {
        const SmoothCurve star = smooth_body(shape, n, 1.6, orientation);
        const SmoothCurve around = smooth_curve(wall, m, Side::fluid_inside, 0.0, 0.0);
        return from_wall ? closest_points(around, star).gap : closest_points(star, around).gap;
      };
      const double fine = gap(1024, 1024, false);
      BOOST_TEST(fine > 0.0);
      for (Index n : {16, 32, 48, 64, 128}) {
        for (Index m : {16, 64, 128, 256, 512}) {
          for (bool from_wall : {false, true}) {
            BOOST_TEST(std::abs(gap(n, m, from_wall) - fine) < 1e-13);
          }
        }
      }
    }
  }
}
