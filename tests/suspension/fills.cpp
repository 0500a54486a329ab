// Tests random fills: they place the requested bodies with the clearance between them, and the same
// seed gives the same bodies.

#include <algorithm>
#include <array>
#include <numbers>
#include <random>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "support/smooth_curve.hpp"
#include "suspension/nodes/random_fill.hpp"
#include "suspension/solver/solver.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

SceneFile filled_cell(std::uint64_t seed) {
  Scene scene;
  scene.seed = seed;
  scene.walls = {{WallRole::outer, Circle{5.0}, {}, 0.0, 64, FixedWall{}},
                 {WallRole::inner, Circle{1.0}, {0.5, 0.0}, 0.0, 32, FixedWall{}}};
  Fill fill;
  fill.body.shape = Ellipse{0.5, 0.25};
  fill.area_fraction = 0.2;
  fill.clearance = 0.05;
  fill.body.n_nodes = 32;
  return {scene, {fill}};
}

// Fills a region of the plane as place_fills() does, but measures every gap in every attempt.
std::vector<Body> placed_by_all_pairs(const SceneFile& file, const std::array<double, 4>& box,
                                      long count) {
  const Scene& scene = file.scene;
  const Fill& fill = file.fills[0];
  std::mt19937_64 random(scene.seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const auto smooth = [](const auto& component, Side side) {
    return test::smooth_curve(component.shape, component.n_nodes, side, component.position,
                              component.orientation);
  };
  std::vector<SmoothCurve> obstacles;
  for (const Wall& wall : scene.walls) {
    obstacles.push_back(
        smooth(wall, wall.role == WallRole::outer ? Side::fluid_inside : Side::fluid_outside));
  }
  for (const Body& body : scene.bodies) obstacles.push_back(smooth(body, Side::fluid_outside));
  std::vector<Body> placed;
  while (std::ssize(placed) < count) {
    const Complex position{uniform(box[0], box[2]), uniform(box[1], box[3])};
    Body body = body_at(fill.body.shape, position, fill.body.n_nodes);
    body.orientation = uniform(0.0, 2.0 * std::numbers::pi);
    const SmoothCurve curve = smooth(body, Side::fluid_outside);
    const Eigen::ArrayXd x = curve.nodes.x.real(), y = curve.nodes.x.imag();
    const bool in_box = (x >= box[0] && y >= box[1] && x <= box[2] && y <= box[3]).all();
    if (fill.box && !in_box) continue;
    if (std::ranges::any_of(obstacles, [&](const SmoothCurve& obstacle) {
          return closest_points(curve, obstacle).gap < fill.clearance;
        })) {
      continue;
    }
    obstacles.push_back(curve);
    placed.push_back(body);
  }
  return placed;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bodies_are_placed_where_a_test_of_all_pairs_leaves_room) {
  SceneFile cell = filled_cell(6);
  // The wall is concave: its arms reach into the bounding circles of bodies that keep their
  // clearance.
  cell.scene.walls[0].shape = Star{5.0, 0.3, 3};
  cell.scene.walls[0].n_nodes = 128;
  SceneFile plane;
  plane.scene.seed = 7;
  plane.scene.bodies = {body_at(Ellipse{2.0, 0.5}, {0.0, 0.0}, 64)};
  plane.fills = {filled_cell(0).fills[0]};
  plane.fills[0].area_fraction.reset();
  plane.fills[0].count = 40;
  plane.fills[0].box = {-4.0, -3.0, 4.0, 3.0};
  const Curve container = sample(cell.scene.walls[0].shape, 128, Side::fluid_inside);
  const auto test = [](const SceneFile& file, const std::array<double, 4>& box) {
    const std::vector<Body> bodies = place_fills(file).bodies;
    const std::vector<Body> placed(bodies.begin() + std::ssize(file.scene.bodies), bodies.end());
    BOOST_TEST(placed.size() > 30U);
    BOOST_TEST((placed == placed_by_all_pairs(file, box, std::ssize(placed))));
  };
  test(plane, *plane.fills[0].box);
  test(cell, {container.x.real().minCoeff(), container.x.imag().minCoeff(),
              container.x.real().maxCoeff(), container.x.imag().maxCoeff()});
}

BOOST_AUTO_TEST_CASE(the_area_fraction_is_met) {
  const Scene scene = place_fills(filled_cell(1));
  const double bodies = static_cast<double>(scene.bodies.size()) * std::numbers::pi * 0.5 * 0.25;
  const double fluid = std::numbers::pi * (25.0 - 1.0);
  BOOST_TEST(std::abs(bodies / fluid - 0.2) < 0.5 * std::numbers::pi * 0.125 / fluid);
}

BOOST_AUTO_TEST_CASE(all_gaps_keep_the_clearance) {
  const SuspensionSolver solver(place_fills(filled_cell(2)));
  const std::vector<Gap> gaps =
      find_gaps(solver.start().configuration, solver.discretisation(), 1e-12);
  BOOST_TEST(gaps.size() > 50U);
  BOOST_TEST(gaps.front().points.gap >= 0.05);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_bodies) {
  BOOST_TEST((place_fills(filled_cell(3)) == place_fills(filled_cell(3))));
  BOOST_TEST((place_fills(filled_cell(3)) != place_fills(filled_cell(4))));
  BOOST_TEST(fill_scene(filled_cell(3)).plan.empty());
}

BOOST_AUTO_TEST_CASE(bodies_stay_inside_their_box_and_keep_away_from_given_bodies) {
  Scene scene;
  scene.seed = 5;
  scene.bodies = {body_at(Circle{1.0}, {0.0, 0.0}, 32)};
  Fill fill;
  fill.body.shape = Circle{0.3};
  fill.count = 25;
  fill.box = {-3.0, -2.0, 3.0, 2.0};
  fill.clearance = 0.02;
  fill.body.n_nodes = 32;
  const Scene filled = place_fills({scene, {fill}});
  BOOST_REQUIRE_EQUAL(filled.bodies.size(), 26U);
  for (std::size_t k = 1; k < filled.bodies.size(); ++k) {
    const Complex centre = filled.bodies[k].position;
    BOOST_TEST(std::abs(centre.real()) <= 2.7 + 1e-12);
    BOOST_TEST(std::abs(centre.imag()) <= 1.7 + 1e-12);
    for (std::size_t j = 0; j < k; ++j) {
      const double radii = 0.3 + (j == 0 ? 1.0 : 0.3);
      BOOST_TEST(std::abs(centre - filled.bodies[j].position) >= radii + 0.02 - 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_area_fraction_below_half_a_body_is_refused) {
  SceneFile file = filled_cell(1);
  const double one = 0.5 * 0.25 / (25.0 - 1.0);
  file.fills[0].area_fraction = 0.51 * one;
  BOOST_TEST(place_fills(file).bodies.size() == 1U);
  file.fills[0].area_fraction = 0.49 * one;
  const auto tells = [](const std::invalid_argument& error) {
    return std::string(error.what()).find("area_fraction = 0.00255") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(place_fills(file), std::invalid_argument, tells);
}

BOOST_AUTO_TEST_CASE(more_bodies_than_can_be_counted_are_refused) {
  SceneFile file = filled_cell(1);
  file.fills[0].box = {0.0, 0.0, 1e12, 1e12};
  const auto tells = [](const std::invalid_argument& error) {
    return std::string(error.what()).find("area_fraction = 0.2 requires ") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(place_fills(file), std::invalid_argument, tells);
}

}  // namespace stokesbook::test
