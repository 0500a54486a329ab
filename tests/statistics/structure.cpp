// Tests the statistics of bodies on arrangements whose statistics are known: uniform random points,
// pairs at a given distance, rows with given gaps, given directions, and rigid rotations.

#include "statistics/structure.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <boost/test/unit_test.hpp>

namespace stokesbook::test {

namespace {

constexpr double pi = std::numbers::pi;

Scene container(double radius, double inner = 0.0) {
  Scene scene;
  scene.walls = {{.role = WallRole::outer, .shape = Circle{radius}}};
  if (inner > 0.0) scene.walls.push_back({.role = WallRole::inner, .shape = Circle{inner}});
  return scene;
}

// A unit cell in the shear u = (y, 0).
Scene sheared_cell() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.cell.emplace();
  scene.cell->vectors << 1.0, 0.0, 0.0, 1.0;
  return scene;
}

Scene with_bodies(Scene scene, const Shape& shape, std::size_t count) {
  scene.bodies.assign(count, Body{.shape = shape});
  return scene;
}

BodyState at(Complex position, double orientation = 0.0, Complex velocity = {},
             double omega = 0.0) {
  return {position, orientation, velocity, omega, {}, 0.0};
}

// Places points uniformly in a ring, independently at each of some times.
BodyFrames random_frames(double inner, double outer, std::size_t count, int times) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform;
  BodyFrames frames;
  for (int k = 0; k < times; ++k) {
    frames.t.push_back(k);
    frames.bodies.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      const double r = std::sqrt(std::lerp(inner * inner, outer * outer, uniform(random)));
      frames.bodies.back().push_back(at(std::polar(r, 2.0 * pi * uniform(random))));
    }
  }
  return frames;
}

// Integrates the density of the distance of two uniform points in a disk of radius one, which is
// 4 s / pi (acos(s / 2) - s / 2 sqrt(1 - s^2 / 4)).
double share_of_pairs(double from, double to) {
  constexpr int points = 2000;
  double sum = 0.0;
  for (int k = 0; k < points; ++k) {
    const double s = std::lerp(from, to, (k + 0.5) / points), half = 0.5 * s;
    sum += 4.0 * s / pi * (std::acos(half) - half * std::sqrt(1.0 - half * half));
  }
  return sum * (to - from) / points;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(structure)

BOOST_AUTO_TEST_CASE(regions) {
  const Scene ring = container(3.0, 1.0);
  for (const double clearance : {0.0, 0.5}) {
    const Region region = region_of(ring, {}, clearance, 5000);
    BOOST_TEST(region.area == (8.0 - 8.0 * clearance) * pi, boost::test_tools::tolerance(5e-3));
    const Eigen::VectorXd radii = region.points.cwiseAbs();
    BOOST_TEST(radii.minCoeff() == 1.0 + clearance, boost::test_tools::tolerance(5e-3));
    BOOST_TEST(radii.maxCoeff() == 3.0 - clearance, boost::test_tools::tolerance(5e-3));
    BOOST_TEST(std::abs(region.points.mean()) < 0.02);
  }
  const Region box = region_of({}, std::array{-1.0, 0.0, 1.0, 3.0}, 0.0, 100);
  BOOST_TEST(box.area == 6.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(box.is_in_box({0.9, 2.9}));
  BOOST_TEST(!box.is_in_box({0.9, 3.1}));
  BOOST_CHECK_THROW(region_of({}, {}, 0.0, 10), SceneError);
  Scene moving = container(3.0);
  moving.walls[0].motion = RotatingWall{1.0};
  BOOST_CHECK_NO_THROW(region_of(moving, {}, 0.0, 10));
  moving.walls[0].shape = Ellipse{3.0, 2.0};
  BOOST_CHECK_THROW(region_of(moving, {}, 0.0, 10), SceneError);
}

// In every bin of every region, uniform points have g = 1, up to four standard errors and the error
// of the reference. Without the correction for edges g falls to zero: so it does in a region that
// is wider than that of the points.
BOOST_AUTO_TEST_CASE(uniform_points_have_no_correlation) {
  const BodyFrames frames = random_frames(1.0, 3.0, 60, 150);
  const Scene ring = with_bodies(container(3.0, 1.0), Circle{1e-3}, 60);
  const Measurement g = pair_correlation(ring, frames, {}, 5.6, 14);
  BOOST_REQUIRE(g.means[0].size() == 14u);
  for (const auto& [mean, standard_error, interval] : g.means[0]) {
    BOOST_TEST(std::abs(mean - 1.0) < 4.0 * standard_error + 0.02, mean);
    BOOST_TEST(standard_error < 0.05);
  }
  const RegionBox wide = std::array{-3.0, -3.0, 3.0, 3.0};
  BOOST_TEST(pair_correlation(ring, frames, wide, 5.6, 14).means[0].back().mean < 0.7);
}

// One pair in a disk: g is one over the share of uniform pairs in the bin of its distance.
BOOST_AUTO_TEST_CASE(the_edge_of_a_disk) {
  const Scene disk = with_bodies(container(1.0), Circle{1e-6}, 2);
  for (const int bin : {0, 4, 8}) {
    const double distance = 0.2 * bin + 0.1;
    const BodyFrames frames{{0.0}, {{at(-0.5 * distance), at(0.5 * distance)}}};
    const Measurement g = pair_correlation(disk, frames, {}, 2.0, 10);
    for (int other = 0; other < 10; ++other) {
      const double mean = g.means[0][static_cast<std::size_t>(other)].mean;
      const double exact = other == bin ? 1.0 / share_of_pairs(0.2 * bin, 0.2 * bin + 0.2) : 0.0;
      BOOST_TEST(std::abs(mean - exact) < 0.03 * exact + 1e-12, mean << " " << exact);
    }
  }
}

// The row of unit disks has the gaps 0.03 and 0.3, and its last disk a gap of 0.003 to the wall.
BOOST_AUTO_TEST_CASE(neighbours_in_a_row) {
  const Scene row = with_bodies(container(10.0), Circle{1.0}, 3);
  const double last = 9.0 - 0.003;
  const BodyFrames frames{{0.0}, {{at(last), at(last - 2.03), at(last - 4.33)}}};
  const Measurement found = neighbours(row, frames);
  for (std::size_t k = 0; k < found.at.size(); ++k) {
    const double h = found.at[k];
    const double pairs = (h > 0.03 ? 1.0 : 0.0) + (h > 0.3 ? 1.0 : 0.0);
    BOOST_TEST(found.means[0][k].mean == 2.0 * pairs / 3.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(found.means[1][k].mean == (h > 0.003 ? 1.0 / 3.0 : 0.0),
               boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(found.at.front() == 1e-4, boost::test_tools::tolerance(1e-3));
  // The places of a wall that moves are not known.
  Scene moving = row;
  moving.walls[0].motion = TranslatingWall{1.0};
  BOOST_TEST(neighbours(moving, frames).quantities.size() == 1u);
}

// A cell in a shear, at the written time 0.3: places are those of paths, which may lie in other
// cells. The numbers of distances in each bin are those of a sum over many lattice vectors.
BOOST_AUTO_TEST_CASE(correlation_in_a_sheared_cell) {
  const Scene cell = with_bodies(sheared_cell(), Circle{0.1}, 3);
  const Complex a1 = 1.0, a2{0.3, 1.0};
  const std::vector<Complex> places{{0.2, 0.1}, {-0.3, 0.35}, {0.15, -0.4}};
  const BodyFrames frames{
      {0.3}, {{at(places[0] + 3.0 * a1 - 2.0 * a2), at(places[1] + 5.0 * a2), at(places[2])}}};
  const double longest = 2.3, width = longest / 10.0;
  std::vector<double> counts(10);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (int j = -9; j <= 9; ++j) {
        for (int k = -9; k <= 9; ++k) {
          const double r = std::abs(places[a] - places[b] + static_cast<double>(j) * a1 +
                                    static_cast<double>(k) * a2);
          if (r < longest) counts[static_cast<std::size_t>(r / width)] += 1.0;
        }
      }
    }
  }
  const Measurement g = pair_correlation(cell, frames, {}, longest, 10);
  for (std::size_t k = 0; k < 10; ++k) {
    const double uniform = 3.0 * 2.0 * pi * g.at[k] * width;  // three pairs, and the area is one
    BOOST_TEST(g.means[0][k].mean == counts[k] / uniform, boost::test_tools::tolerance(1e-12));
  }
}

// Uniform points have g = 1 at every distance, also beyond the size of the cell.
BOOST_AUTO_TEST_CASE(uniform_points_in_a_cell) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform;
  BodyFrames frames;
  for (int k = 0; k < 100; ++k) {
    frames.t.push_back(0.1 * k);
    frames.bodies.emplace_back();
    const Complex a2{0.1 * k, 1.0};
    for (int i = 0; i < 20; ++i) {
      frames.bodies.back().push_back(at(uniform(random) + uniform(random) * a2));
    }
  }
  const Scene cell = with_bodies(sheared_cell(), Circle{1e-3}, 20);
  const Measurement g = pair_correlation(cell, frames, {}, 1.5, 5);
  for (const auto& [mean, error, interval] : g.means[0]) {
    BOOST_TEST(std::abs(mean - 1.0) < 4.0 * error, mean);
    BOOST_TEST(error < 0.02);
  }
}

// A disk of the diameter 0.9 has two images at the distance 1, two at |(0.3, 1)| and two at
// |(0.7, 1)|.
BOOST_AUTO_TEST_CASE(images_as_neighbours) {
  const Scene cell = with_bodies(sheared_cell(), Circle{0.45}, 1);
  const BodyFrames frames{{0.3}, {{at({-4.0, 7.0})}}};
  const Measurement found = neighbours(cell, frames);
  for (std::size_t k = 0; k < found.at.size(); ++k) {
    double images = 0.0;
    for (const Complex w : {Complex{1.0}, Complex{0.3, 1.0}, Complex{0.7, 1.0}}) {
      if (std::abs(w) - 0.9 < found.at[k]) images += 2.0;
    }
    BOOST_TEST(found.means[0][k].mean == images, found.at[k]);
  }
  BOOST_TEST(found.means[0].back().mean == 6.0);
}

// The long axis of the ellipses is their second one.
BOOST_AUTO_TEST_CASE(directions) {
  const Scene scene = with_bodies({}, Ellipse{1.0, 2.0}, 8);
  BodyFrames frames{{0.0}, {{}}};
  for (int k = 0; k < 8; ++k) frames.bodies[0].push_back(at(5.0 * k, 0.3 + pi * (k % 3)));
  BOOST_TEST(nematic_order(scene, frames)[0] == 1.0, boost::test_tools::tolerance(1e-12));
  const Measurement parallel = orientations(scene, frames, 10);
  for (std::size_t k = 0; k < 10; ++k) {
    const bool holds = std::abs(parallel.at[k] - (0.3 + 0.5 * pi)) < 0.05 * pi;
    BOOST_TEST(parallel.means[0][k].mean == (holds ? 10.0 / pi : 0.0),
               boost::test_tools::tolerance(1e-12));
  }
  for (std::size_t k = 0; k < 8; ++k) {
    frames.bodies[0][k].orientation = 0.2 + pi / 8.0 * static_cast<double>(k);
  }
  BOOST_TEST(nematic_order(scene, frames)[0] < 1e-12);
  BOOST_TEST(orientations(with_bodies({}, Circle{1.0}, 8), frames, 10).at.empty());
}

// A disk in the middle turns rigidly; then it lies beside the middle, and moves to the right.
BOOST_AUTO_TEST_CASE(profiles) {
  const Scene scene = with_bodies(container(2.0), Circle{1.0}, 1);
  const Measurement radial =
      profile(scene, {{0.0}, {{at({}, 0.4, {}, 0.7)}}}, {}, Across::radius, 16);
  for (std::size_t k = 1; k < 16; ++k) {
    const double r = radial.at[k];
    BOOST_TEST(std::abs(radial.means[0][k].mean - (r < 1.0 ? 1.0 : 0.0)) < 0.06);
    if (r > 1.0) continue;
    BOOST_TEST(std::abs(radial.means[1][k].mean) < 1e-12);
    BOOST_TEST(std::abs(radial.means[2][k].mean - 0.7 * r) < 0.03);
  }
  const Measurement along =
      profile(scene, {{0.0}, {{at({0.3, 0.1}, 0.0, {2.0, -1.0})}}}, {}, Across::x, 20);
  double area = 0.0;
  for (std::size_t k = 0; k < 20; ++k) {
    const double x = along.at[k], half = std::sqrt(std::max(0.0, 1.0 - (x - 0.3) * (x - 0.3)));
    const double height = 2.0 * std::sqrt(4.0 - x * x);
    area += 0.2 * height * along.means[0][k].mean;
    if (std::abs(x - 0.3) < 0.8) {
      BOOST_TEST(along.means[0][k].mean == 2.0 * half / height, boost::test_tools::tolerance(0.06));
      BOOST_TEST(along.means[1][k].mean == 2.0, boost::test_tools::tolerance(1e-10));
      BOOST_TEST(along.means[2][k].mean == -1.0, boost::test_tools::tolerance(1e-10));
    }
  }
  BOOST_TEST(area == pi, boost::test_tools::tolerance(0.01));
}

// All disks have one stresslet, so that the stress is their area fraction times stresslet over
// area: S_11 and S_12 across x, and turned by the angle of the place across the radius.
BOOST_AUTO_TEST_CASE(profiles_of_stress) {
  const double a = 0.4;
  const Complex stresslet(0.3, -1.7);
  const Scene scene = with_bodies(container(4.0), Circle{a}, 3);
  const BodyFrames frames{
      {0.0}, {{at({0.5, 0.2}), at(-1.5), at({0.3, -2.0})}}, {{stresslet, stresslet, stresslet}}};
  const Measurement along = profile(scene, frames, {}, Across::x, 20);
  BOOST_REQUIRE(along.means.size() == 5u);
  BOOST_TEST(along.quantities[4] == "particle_shear_stress");
  Complex sum = 0.0;
  for (std::size_t k = 0; k < 20; ++k) {
    const Complex stress(along.means[3][k].mean, along.means[4][k].mean);
    const Complex expected = along.means[0][k].mean * stresslet / (pi * a * a);
    BOOST_TEST(std::abs(stress - expected) < 1e-12);
    sum += 0.4 * 2.0 * std::sqrt(16.0 - along.at[k] * along.at[k]) * stress;
  }
  BOOST_TEST(std::abs(sum - 3.0 * stresslet) < 0.02 * std::abs(stresslet));
  // A small disk in the direction phi has the stresslet S e^{-2 i phi} in polar coordinates.
  const double phi = 0.7;
  const Measurement radial =
      profile(with_bodies(container(4.0), Circle{0.01}, 1),
              {{0.0}, {{at(std::polar(2.1, phi))}}, {{stresslet}}}, {}, Across::radius, 20);
  const Complex stress(radial.means[3][10].mean, radial.means[4][10].mean);
  const Complex expected = stresslet * std::polar(1.0, -2.0 * phi);
  const double bin_area = pi * (2.2 * 2.2 - 2.0 * 2.0);
  BOOST_TEST(std::abs(stress * bin_area - expected) < 0.02 * std::abs(expected));
  // Without stresslets there is no stress.
  BOOST_TEST(profile(scene, {frames.t, frames.bodies}, {}, Across::x, 20).means.size() == 3u);
}

BOOST_AUTO_TEST_CASE(tables_and_plots) {
  Measurement measurement{"m", "r", {1.0, 2.0}};
  measurement.add("g", {0.0}, Eigen::RowVector2d(3.0, 4.0));
  BOOST_TEST(to_csv(measurement) == "r,g,g_standard_error,g_interval\n1,3,nan,nan\n2,4,nan,nan\n");
  BOOST_TEST(draw(measurement, 0).starts_with("<svg"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
