// Random fills place what they are asked for, apart by their clearance, the same for the same seed.

#include <numbers>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "suspension/fill.hpp"
#include "suspension/solver.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

Scene filled_cell(std::uint64_t seed) {
  Scene scene;
  scene.seed = seed;
  scene.walls = {{WallRole::outer, Circle{5.0}, {}, 0.0, 64, FixedWall{}},
                 {WallRole::inner, Circle{1.0}, {0.5, 0.0}, 0.0, 32, FixedWall{}}};
  Fill fill;
  fill.shape = Ellipse{0.5, 0.25};
  fill.area_fraction = 0.2;
  fill.clearance = 0.05;
  fill.n_nodes = 32;
  scene.fills = {fill};
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_area_fraction_is_met) {
  const Scene scene = with_fills_placed(filled_cell(1));
  const double bodies = static_cast<double>(scene.bodies.size()) * std::numbers::pi * 0.5 * 0.25;
  const double fluid = std::numbers::pi * (25.0 - 1.0);
  BOOST_TEST(std::abs(bodies / fluid - 0.2) < 0.5 * std::numbers::pi * 0.125 / fluid);
  BOOST_TEST(scene.fills.empty());
}

BOOST_AUTO_TEST_CASE(all_gaps_keep_the_clearance) {
  const SuspensionSolver solver(with_fills_placed(filled_cell(2)));
  const std::vector<Gap> gaps =
      find_gaps(solver.initial_configuration(), solver.references(), 1e-12);
  BOOST_TEST(gaps.size() > 50U);
  BOOST_TEST(gaps.front().points.gap >= 0.05);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_bodies) {
  BOOST_TEST((with_fills_placed(filled_cell(3)) == with_fills_placed(filled_cell(3))));
  BOOST_TEST((with_fills_placed(filled_cell(3)) != with_fills_placed(filled_cell(4))));
}

BOOST_AUTO_TEST_CASE(bodies_stay_inside_their_box_and_keep_away_from_given_bodies) {
  Scene scene;
  scene.seed = 5;
  scene.bodies = {body_at(Circle{1.0}, {0.0, 0.0}, 32)};
  Fill fill;
  fill.shape = Circle{0.3};
  fill.count = 25;
  fill.box = {-3.0, -2.0, 3.0, 2.0};
  fill.clearance = 0.02;
  fill.n_nodes = 32;
  scene.fills = {fill};
  const Scene filled = with_fills_placed(scene);
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

BOOST_AUTO_TEST_CASE(a_fill_that_does_not_fit_says_how_far_it_got) {
  Scene scene = filled_cell(1);
  scene.fills[0].area_fraction = 0.8;
  const auto tells = [](const std::invalid_argument& error) {
    return std::string(error.what()).find("found room for") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(with_fills_placed(scene), std::invalid_argument, tells);
}

}  // namespace stokesbook::test
