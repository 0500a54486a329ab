// Tests fills in a periodic cell: all gaps to images, measured one by one, keep the clearance, and
// the same seed gives the same bodies.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "support/smooth_curve.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/nodes/random_fill.hpp"
#include "trajectories.hpp"

namespace stokesbook::test {

namespace {

using std::numbers::pi;

// Returns a fill of a cell that is sheared by more than half a period, about a centre.
SceneFile filled(const Shape& shape, double area_fraction, double clearance, double size,
                 std::uint64_t seed) {
  Scene scene;
  scene.seed = seed;
  scene.flow = ShearFlow{1.0, {3.0, -7.0}};
  scene.cell.emplace();
  scene.cell->vectors << size, 0.0, 0.7 * size, 1.1 * size;
  Fill fill;
  fill.body.shape = shape;
  fill.body.n_nodes = 32;
  fill.area_fraction = area_fraction;
  fill.clearance = clearance;
  return {scene, {fill}};
}

Lattice lattice_at_start(const Scene& scene) {
  return lattice_of(*cell_at(scene, 0.0));
}

SmoothCurve curve_of(const Body& body, Complex shift = 0.0) {
  return smooth_body(body.shape, 64, body.position + shift, body.orientation);
}

// Returns the least gap of a body and all images of another; without the body itself.
double least_gap(const Body& body, const Body& other, const Lattice& lattice) {
  double least = 1e9;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      const Complex w = lattice.vector({i, j});
      if ((&body == &other && w == 0.0) ||
          std::abs(body.position - other.position - w) > 3.0 * std::abs(lattice.second())) {
        continue;
      }
      least = std::min(least, closest_points(curve_of(body), curve_of(other, w)).gap);
    }
  }
  return least;
}

double least_gap(const Scene& scene) {
  const Lattice lattice = lattice_at_start(scene);
  double least = 1e9;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    for (std::size_t j = 0; j <= k; ++j) {
      least = std::min(least, least_gap(scene.bodies[k], scene.bodies[j], lattice));
    }
  }
  return least;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cell_fills)

// Bodies that are longer than half the cell, whose own images limit their orientations.
BOOST_AUTO_TEST_CASE(bodies_are_placed_where_a_test_of_all_images_leaves_room) {
  const Ellipse shape{0.49, 0.06};
  int limited_by_own_image = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = place_fills(filled(shape, 0.17, 0.1, 1.0, seed));
    BOOST_TEST(scene.bodies.size() == 2U);  // 0.17 * 1.1 / (0.49 0.06 pi) = 2.02
    std::mt19937_64 random(seed);
    const auto uniform = [&](double high) {
      return high * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    const Lattice lattice = lattice_at_start(scene);
    std::vector<Body> placed;
    while (placed.size() < scene.bodies.size()) {
      const double i = uniform(1.0), j = uniform(1.0);
      const Complex anywhere = i * Complex{1.0} + j * Complex{0.7, 1.1};
      placed.push_back(body_at(shape, lattice.wrap(anywhere, {3.0, -7.0}), 32));
      Body& last = placed.back();
      last.orientation = uniform(2.0 * pi);
      const bool meets_itself = least_gap(last, last, lattice) < 0.1;
      limited_by_own_image += meets_itself ? 1 : 0;
      if (meets_itself || std::ranges::any_of(placed, [&](const Body& other) {
            return &other != &last && least_gap(last, other, lattice) < 0.1;
          })) {
        placed.pop_back();
      }
    }
    for (std::size_t k = 0; k < placed.size(); ++k) {
      BOOST_TEST(std::abs(placed[k].position - scene.bodies[k].position) < 1e-13);
      BOOST_TEST(placed[k].orientation == scene.bodies[k].orientation);
    }
  }
  BOOST_TEST(limited_by_own_image > 0);
}

BOOST_AUTO_TEST_CASE(inserted_bodies_keep_their_clearance_across_edges) {
  SceneFile file = filled(Circle{0.5}, 0.4, 0.02, 5.0, 1);
  file.scene.bodies = {body_at(Ellipse{1.2, 0.4}, {23.0, 40.0}, 64)};  // far from the cell
  const FilledScene filled = fill_scene(file);
  BOOST_TEST(filled.plan.empty());
  BOOST_TEST(filled.scene.bodies.size() == 1U + 14U);  // 0.4 * 27.5 / (0.25 pi) = 14.0
  BOOST_TEST(least_gap(filled.scene) >= 0.02);
  const Lattice lattice = lattice_at_start(file.scene);
  for (std::size_t k = 1; k < filled.scene.bodies.size(); ++k) {
    const Complex place = filled.scene.bodies[k].position;
    BOOST_TEST(std::abs(lattice.wrap(place, {3.0, -7.0}) - place) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(dense_bodies_keep_their_clearance_across_edges) {
  const FilledScene disks = fill_scene(filled(Circle{1.0}, 0.72, 0.02, 7.0, 2));
  BOOST_TEST(disks.plan.size() == 1U);
  BOOST_TEST(disks.scene.bodies.size() == 12U);  // 0.72 * 53.9 / pi = 12.4
  BOOST_TEST(least_gap(disks.scene) >= 0.02);
  // The given body does not move, wherever its path has led it.
  SceneFile file = filled(Ellipse{1.0, 0.5}, 0.6, 0.01, 5.0, 3);
  file.scene.bodies = {body_at(Circle{0.6}, {23.0, 40.0}, 64)};
  const FilledScene ellipses = fill_scene(file);
  BOOST_TEST(ellipses.plan.size() == 1U);
  BOOST_TEST((ellipses.scene.bodies[0] == file.scene.bodies[0]));
  BOOST_TEST(least_gap(ellipses.scene) >= 0.01);
}

BOOST_AUTO_TEST_CASE(seeds_and_threads) {
  const auto bodies = [](double area_fraction, std::uint64_t seed) {
    return place_fills(filled(Ellipse{1.0, 0.6}, area_fraction, 0.01, 6.0, seed)).bodies;
  };
  for (const double area_fraction : {0.3, 0.65}) {
    const std::vector<Body> first = bodies(area_fraction, 1);
    const int before = omp_get_max_threads();
    omp_set_num_threads(3);
    BOOST_TEST((bodies(area_fraction, 1) == first));
    omp_set_num_threads(before);
    BOOST_TEST((bodies(area_fraction, 2) != first));
  }
}

// A disk that is wider than the cell finds no room, although its area is less than that of the
// cell.
BOOST_AUTO_TEST_CASE(bodies_wider_than_the_cell_are_refused) {
  SceneFile file = filled(Circle{0.51}, 0.7, 0.0, 1.0, 1);
  file.fills[0].area_fraction.reset();
  file.fills[0].count = 1;
  const auto tells = [](const std::invalid_argument& error) {
    return std::string(error.what()).starts_with("[[fill]]: found room for an area fraction of ");
  };
  BOOST_CHECK_EXCEPTION(place_fills(file), std::invalid_argument, tells);
  file.fills[0].body.shape = Circle{0.49};
  BOOST_TEST(place_fills(file).bodies.size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
