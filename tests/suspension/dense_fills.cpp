// Tests fills that are too dense for random insertion: the bodies keep their clearance, measured
// independently of the polygons that move them apart, and their arrangement is random.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "suspension/nodes/random_fill.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

using std::numbers::pi;

Fill fill_of(const Shape& shape, double area_fraction, double clearance) {
  Fill fill;
  fill.body.shape = shape;
  fill.area_fraction = area_fraction;
  fill.clearance = clearance;
  fill.body.n_nodes = 64;
  return fill;
}

// Returns a square box in which so many bodies of an area have an area fraction.
std::array<double, 4> box_for(double bodies, double body_area, double area_fraction) {
  const double half = 0.5 * std::sqrt(bodies * body_area / area_fraction);
  return {-half, -half, half, half};
}

// A ring with an inner wall off its centre, a given body, and a fill.
SceneFile ring(const Fill& fill, double radius) {
  Scene scene;
  scene.seed = 3;
  scene.walls = {{WallRole::outer, Circle{radius}, {1.0, 2.0}, 0.0, 128, FixedWall{}},
                 {WallRole::inner, Circle{0.3 * radius}, {1.5, 2.0}, 0.0, 64, FixedWall{}}};
  scene.bodies = {body_at(Circle{1.5}, {1.0, 2.0 + 0.6 * radius}, 64)};
  return {scene, {fill}};
}

SceneFile plane(const std::vector<Fill>& fills, std::uint64_t seed) {
  Scene scene;
  scene.seed = seed;
  return {scene, fills};
}

// Returns the signed distance of a point from an ellipse in its own frame. The foot is
// (a^2 x / (m + a^2), b^2 y / (m + b^2)), where m > -b^2 is the root of the ellipse's equation,
// which bisection finds; a >= b.
double distance_to_ellipse(double a, double b, Complex z) {
  const double x = std::abs(z.real()), y = std::abs(z.imag());
  double low = -b * b + b * y, high = -b * b + std::hypot(a * x, b * y);
  for (int k = 0; k < 60; ++k) {
    const double m = 0.5 * (low + high);
    const double value = std::hypot(a * x / (m + a * a), b * y / (m + b * b));
    (value > 1.0 ? low : high) = m;
  }
  const double distance = std::hypot(x - a * a * x / (low + a * a), y - b * b * y / (low + b * b));
  return std::copysign(distance, std::hypot(x / a, y / b) - 1.0);
}

// Returns the least distance of two ellipses: the least one of 200 points of the first, then of
// points about it that are ever closer to each other.
double ellipse_gap(const Body& of, const Body& about) {
  const Ellipse other = std::get<Ellipse>(about.shape), first = std::get<Ellipse>(of.shape);
  const auto distance = [&](double t) {
    const Complex own{first.a * std::cos(t), first.b * std::sin(t)};
    const Complex place = of.position + std::polar(1.0, of.orientation) * own;
    return distance_to_ellipse(other.a, other.b,
                               std::polar(1.0, -about.orientation) * (place - about.position));
  };
  double nearest = 0.0, from = 0.0, width = pi;
  for (int points = 200; width > 1e-6; points = 20) {
    for (int k = -points / 2; k <= points / 2; ++k) {
      const double t = from + 2.0 * width * k / points;
      if (distance(t) < distance(nearest)) nearest = t;
    }
    from = nearest;
    width *= 4.0 / points;
  }
  return distance(nearest);
}

// Returns the least gap of all pairs of circles, and of circles and circular walls.
double least_circle_gap(const Scene& scene) {
  const auto radius = [](const auto& component) {
    return std::get<Circle>(component.shape).radius;
  };
  double least = 1e9;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    for (std::size_t j = 0; j < k; ++j) {
      const Body& other = scene.bodies[j];
      least =
          std::min(least, std::abs(body.position - other.position) - radius(body) - radius(other));
    }
    for (const Wall& wall : scene.walls) {
      const double distance = std::abs(body.position - wall.position);
      least =
          std::min(least, wall.role == WallRole::outer ? radius(wall) - distance - radius(body)
                                                       : distance - radius(wall) - radius(body));
    }
  }
  return least;
}

double least_ellipse_gap(const std::vector<Body>& bodies) {
  double least = 1e9;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const double reach =
          std::get<Ellipse>(bodies[k].shape).a + std::get<Ellipse>(bodies[j].shape).a;
      if (std::abs(bodies[k].position - bodies[j].position) > reach + 1.0) continue;
      least = std::min(least, ellipse_gap(bodies[k], bodies[j]));
    }
  }
  return least;
}

// Returns the largest coordinate that a circle or an ellipse reaches: of an ellipse, the distance
// of a tangent along an axis from the centre is hypot(a cos theta, b sin theta).
double farthest_coordinate(const Body& body) {
  Ellipse ellipse;
  if (const auto* circle = std::get_if<Circle>(&body.shape)) {
    ellipse = {circle->radius, circle->radius};
  } else {
    ellipse = std::get<Ellipse>(body.shape);
  }
  const double c = std::cos(body.orientation), s = std::sin(body.orientation);
  return std::max(std::abs(body.position.real()) + std::hypot(ellipse.a * c, ellipse.b * s),
                  std::abs(body.position.imag()) + std::hypot(ellipse.a * s, ellipse.b * c));
}

// Returns the mean of e^{i m theta} over the orientations of bodies.
Complex orientation_order(const std::vector<Body>& bodies, double m) {
  Complex sum = 0.0;
  for (const Body& body : bodies) sum += std::polar(1.0, m * body.orientation);
  return sum / static_cast<double>(bodies.size());
}

// Returns psi_6 of the bodies that are farther than `margin` from the box: the mean of
// e^{6 i phi} over the directions phi to the six nearest bodies.
std::vector<Complex> hexatic_order(const std::vector<Body>& bodies, double half, double margin) {
  std::vector<Complex> orders;
  for (const Body& body : bodies) {
    const Complex centre = body.position;
    if (std::max(std::abs(centre.real()), std::abs(centre.imag())) > half - margin) continue;
    std::vector<Complex> steps;
    for (const Body& other : bodies) steps.push_back(other.position - centre);
    std::ranges::nth_element(steps, steps.begin() + 7, {},
                             [](const Complex& step) { return std::abs(step); });
    Complex order = 0.0;
    for (int k = 0; k < 7; ++k) {  // the body itself is among the seven
      const Complex step = steps[static_cast<std::size_t>(k)];
      if (step != 0.0) order += std::polar(1.0 / 6.0, 6.0 * std::arg(step));
    }
    orders.push_back(order);
  }
  return orders;
}

// Requires that both halves, in x and in y, the inner and the outer half of the box hold about as
// many bodies.
void check_uniform(const std::vector<Body>& bodies, double half) {
  const double count = static_cast<double>(bodies.size());
  const auto part = [&](const auto& holds) {
    return static_cast<double>(std::ranges::count_if(bodies, holds)) / count;
  };
  BOOST_TEST(std::abs(part([](const Body& b) { return b.position.real() < 0.0; }) - 0.5) < 0.03);
  BOOST_TEST(std::abs(part([](const Body& b) { return b.position.imag() < 0.0; }) - 0.5) < 0.03);
  const auto is_inner = [&](const Body& b) {
    return std::max(std::abs(b.position.real()), std::abs(b.position.imag())) <
           half * std::sqrt(0.5);
  };
  BOOST_TEST(std::abs(part(is_inner) - 0.5) < 0.04);
}

}  // namespace

BOOST_AUTO_TEST_CASE(dense_disks_keep_their_clearance_in_a_ring) {
  const FilledScene filled = fill_scene(ring(fill_of(Circle{1.0}, 0.62, 0.02), 8.0));
  BOOST_TEST(filled.plan.size() == 1U);
  BOOST_TEST(filled.scene.bodies.size() == 37U);  // one is given: 0.62 (64 - 5.76) = 36.1
  BOOST_TEST(least_circle_gap(filled.scene) >= 0.02);
  BOOST_TEST((filled.scene.bodies[0] == ring({}, 8.0).scene.bodies[0]));
}

BOOST_AUTO_TEST_CASE(dense_ellipses_keep_their_clearance_in_a_box) {
  Fill fill = fill_of(Ellipse{1.5, 0.5}, 0.65, 0.01);
  fill.box = box_for(40.0, 0.75 * pi, 0.65);
  const std::vector<Body> bodies = place_fills(plane({fill}, 1)).bodies;
  BOOST_TEST(bodies.size() == 40U);
  BOOST_TEST(least_ellipse_gap(bodies) >= 0.01);
  for (const Body& body : bodies) BOOST_TEST(farthest_coordinate(body) <= (*fill.box)[2]);
}

BOOST_AUTO_TEST_CASE(dense_mixtures_keep_their_clearance_and_their_boxes) {
  Fill large = fill_of(Circle{1.4}, 0.4, 0.01), small = fill_of(Circle{1.0}, 0.35, 0.03);
  large.box = small.box = box_for(20.0, 1.96 * pi, 0.4);
  Fill apart = fill_of(Circle{0.5}, 0.7, 0.0);
  apart.box = {20.0, 0.0, 26.0, 6.0};
  const Scene scene = place_fills(plane({large, small, apart}, 2));
  BOOST_TEST(scene.bodies.size() == 20U + 34U + 32U);
  BOOST_TEST(least_circle_gap(scene) >= 0.0);
  // A body keeps its clearance from all bodies before it, as in random insertion.
  Scene first{scene};
  first.bodies.resize(20);
  BOOST_TEST(least_circle_gap(first) >= 0.01);
  for (std::size_t k = 20; k < 54; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const double distance = std::abs(scene.bodies[k].position - scene.bodies[j].position);
      BOOST_TEST(distance >= 1.0 + (j < 20 ? 1.4 : 1.0) + 0.03);
    }
  }
  for (std::size_t k = 0; k < 86; ++k) {
    const Body& body = scene.bodies[k];
    if (k < 54) {
      BOOST_TEST(farthest_coordinate(body) <= (*large.box)[2]);
    } else {
      BOOST_TEST(std::abs(body.position.real() - 23.0) <= 2.5);
      BOOST_TEST(std::abs(body.position.imag() - 3.0) <= 2.5);
    }
  }
}

BOOST_AUTO_TEST_CASE(dense_fills_do_not_depend_on_the_number_of_threads) {
  Fill fill = fill_of(Ellipse{1.5, 0.5}, 0.6, 0.0);
  fill.box = box_for(20.0, 0.75 * pi, 0.6);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const FilledScene one = fill_scene(plane({fill}, 4));
  omp_set_num_threads(3);
  const FilledScene three = fill_scene(plane({fill}, 4));
  omp_set_num_threads(threads);
  BOOST_TEST(!one.plan.empty());
  BOOST_TEST((one.scene == three.scene));
  BOOST_TEST((one.scene != place_fills(plane({fill}, 5))));
}

BOOST_AUTO_TEST_CASE(an_impossible_fill_names_the_area_fraction_that_it_reached) {
  Fill fill = fill_of(Circle{1.0}, 0.95, 0.0);
  fill.box = box_for(12.0, pi, 0.95);
  const auto tells = [](const std::invalid_argument& error) {
    const std::string text = error.what(), found = "[[fill]]: found room for an area fraction of ";
    if (!text.starts_with(found)) return false;
    const double reached = std::stod(text.substr(found.size()));
    return reached > 0.65 && reached < 0.9 && text.find(" of 0.95; lower") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(fill_scene(plane({fill}, 1)), std::invalid_argument, tells);
}

BOOST_AUTO_TEST_CASE(a_thousand_dense_disks_are_uniform_and_no_crystal,
                     *boost::unit_test::label("full")) {
  Fill fill = fill_of(Circle{1.0}, 0.75, 0.0);
  fill.box = box_for(1000.0, pi, 0.75);
  const double half = (*fill.box)[2];
  const Scene scene = place_fills(plane({fill}, 1));
  BOOST_TEST(scene.bodies.size() == 1000U);
  BOOST_TEST(least_circle_gap(scene) > 0.0);
  check_uniform(scene.bodies, half);
  // A crystal has |psi_6| = 1 everywhere, and one direction.
  const std::vector<Complex> orders = hexatic_order(scene.bodies, half, 3.0);
  Complex sum = 0.0;
  double moduli = 0.0;
  for (const Complex& order : orders) {
    sum += order;
    moduli += std::abs(order);
  }
  const double count = static_cast<double>(orders.size());
  BOOST_TEST_MESSAGE("psi_6: local " << moduli / count << ", of all " << std::abs(sum) / count);
  BOOST_TEST(moduli / count < 0.75);
  BOOST_TEST(std::abs(sum) / count < 0.2);
}

BOOST_AUTO_TEST_CASE(a_thousand_dense_ellipses_are_uniform_and_isotropic,
                     *boost::unit_test::label("full")) {
  Fill fill = fill_of(Ellipse{3.0, 1.0}, 0.65, 0.0);
  fill.box = box_for(1000.0, 3.0 * pi, 0.65);
  const std::vector<Body> bodies = place_fills(plane({fill}, 1)).bodies;
  BOOST_TEST(bodies.size() == 1000U);
  BOOST_TEST(least_ellipse_gap(bodies) > 0.0);
  check_uniform(bodies, (*fill.box)[2]);
  // Independent orientations have 1 / sqrt(1000) = 0.03; neighbours are partly aligned.
  BOOST_TEST(std::abs(orientation_order(bodies, 2.0)) < 0.12);
  BOOST_TEST(std::abs(orientation_order(bodies, 4.0)) < 0.12);
}

}  // namespace stokesbook::test
