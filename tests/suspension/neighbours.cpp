// Tests that the searches for neighbours find the same results as tests of all pairs: gaps, the
// closest pair if no pair is in reach, and the points that lie in the fluid.

#include <numbers>
#include <random>

#include <omp.h>

#include "near_singular/barycentric.hpp"
#include "near_singular/near_field.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/scenes.hpp"
#include "suspension/solver/fields.hpp"

namespace stokesbook::test {

namespace {

// Returns bodies of several shapes on a lattice with some empty places; some of the bodies touch.
Scene random_bodies(unsigned seed, double spacing) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const std::vector<Shape> shapes{Circle{0.3}, Ellipse{0.5, 0.1}, Star{0.4, 0.2, 3}};
  Scene result;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      if (random() % 5 == 0) continue;
      const Complex place =
          spacing * (Complex(i, j) + 0.2 * Complex{uniform(random), uniform(random)});
      result.bodies.push_back(body(shapes[random() % 3], 32, place, 3.0 * uniform(random)));
    }
  }
  return result;
}

// The container is not convex: bodies lie between its arms, and on both sides of its boundary.
Scene contained(Scene scene) {
  scene.walls = {outer_wall(Star{4.0, 0.3, 5}, 128, {}, {0.2, 0.1}, 0.3),
                 inner_wall(Ellipse{1.0, 0.4}, 64, {}, {7.0, 0.5})};
  return scene;
}

struct Placed {
  explicit Placed(const Scene& scene)
      : solver(scene),
        discretisation(solver.discretisation()),
        configuration(solver.start().configuration) {}

  Gap gap(std::size_t a, std::size_t b) const {
    return {a, b,
            closest_points(smooth_curve(*discretisation[a], configuration[a]),
                           smooth_curve(*discretisation[b], configuration[b]))};
  }

  bool in_reach(std::size_t a, std::size_t b, double tolerance) const {
    const Curve &p = discretisation[a]->curve, &q = discretisation[b]->curve;
    if (p.side == Side::fluid_inside || q.side == Side::fluid_inside) return true;
    const double apart = std::abs(configuration[a].position - configuration[b].position) -
                         outer_radius(p, 0.0) - outer_radius(q, 0.0);
    return apart < std::max(near_reach(p, tolerance), near_reach(q, tolerance));
  }

  SuspensionSolver solver;
  Discretisation discretisation;
  Configuration configuration;
};

bool is_narrower(const Gap& p, const Gap& q) {
  return p.points.gap < q.points.gap;
}

// Returns the gaps of all pairs in reach in ascending order. The closest pair of all comes first,
// even if it is out of reach.
std::vector<Gap> gaps_of_all_pairs(const Placed& placed, double tolerance) {
  std::vector<Gap> near, far;
  for (std::size_t a = 0; a < placed.configuration.size(); ++a) {
    for (std::size_t b = a + 1; b < placed.configuration.size(); ++b) {
      (placed.in_reach(a, b, tolerance) ? near : far).push_back(placed.gap(a, b));
    }
  }
  std::ranges::stable_sort(near, is_narrower);
  const auto closest = std::ranges::min_element(far, is_narrower);
  if (closest != far.end() && (near.empty() || is_narrower(*closest, near.front()))) {
    near.insert(near.begin(), *closest);
  }
  return near;
}

// Compares the gaps with those of all pairs. Returns whether the closest pair is out of reach.
bool test_gaps(const Scene& scene, double tolerance) {
  const Placed placed(scene);
  const std::vector<Gap> expected = gaps_of_all_pairs(placed, tolerance);
  for (int threads : {1, 2}) {
    omp_set_num_threads(threads);
    const std::vector<Gap> gaps = find_gaps(placed.configuration, placed.discretisation, tolerance);
    BOOST_REQUIRE_EQUAL(gaps.size(), expected.size());
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      BOOST_TEST(gaps[i].a == expected[i].a);
      BOOST_TEST(gaps[i].b == expected[i].b);
      BOOST_TEST(gaps[i].points.gap == expected[i].points.gap);
      BOOST_TEST(gaps[i].points.parameter_a == expected[i].points.parameter_a);
    }
  }
  omp_set_num_threads(1);
  return !placed.in_reach(expected.front().a, expected.front().b, tolerance);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_gaps_are_found_as_in_a_test_of_all_pairs) {
  for (unsigned seed : {1u, 2u}) {
    for (double tolerance : {1e-2, 1e-12}) {
      BOOST_TEST(!test_gaps(random_bodies(seed, 1.0), tolerance));
      BOOST_TEST(!test_gaps(contained(random_bodies(seed, 1.0)), tolerance));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_closest_pair_is_found_out_of_reach) {
  for (unsigned seed : {3u, 4u, 5u}) {
    BOOST_TEST(test_gaps(random_bodies(seed, 5.0), 1e-2));
    BOOST_TEST(test_gaps(random_bodies(seed, 1e6), 1e-2));
  }
  // One pair is in reach of a coarse body. Another pair is closer, but in reach of no body.
  Scene scene = random_bodies(6, 5.0);
  scene.bodies.push_back(body(Circle{20.0}, 8, {100.0, 0.0}));
  scene.bodies.push_back(body(Circle{1.0}, 256, {100.0, 24.0}));
  BOOST_TEST(test_gaps(scene, 1e-2));
  const auto test = [](std::vector<Body> bodies) {
    BOOST_TEST(test_gaps(stokesbook::test::scene(std::move(bodies)), 1e-2));
  };
  test({body(Circle{1.0}, 32, {0.0, 0.0}), body(Ellipse{1.0, 0.5}, 32, {1e3, -50.0})});
  // The bounding circles of the two ellipses are closer than those of the two circles, but the
  // circles are the closest pair.
  test({body(Ellipse{1.0, 0.1}, 256, {0.0, 0.0}), body(Ellipse{1.0, 0.1}, 256, {0.0, 2.06}),
        body(Circle{0.3}, 256, {50.0, 0.0}), body(Circle{0.3}, 256, {51.1, 0.0})});
  // The tips of the stars lie between nodes. The gap between the stars is smaller than the gap
  // between the two circles, but the bounding circles of the stars' nodes are farther apart.
  const Star star{1.0, -0.3, 4};
  const double tip = std::numbers::pi / 4.0, gap = 1.0;
  test({body(star, 66, {0.0, 0.0}, tip), body(star, 66, {2.6 + gap, 0.0}, tip),
        body(Circle{0.3}, 256, {50.0, 0.0}), body(Circle{0.3}, 256, {50.6 + gap + 1e-3, 0.0})});
}

BOOST_AUTO_TEST_CASE(one_component_has_no_gaps) {
  const Placed alone(scene({body(Circle{1.0}, 32, {0.0, 0.0})}));
  BOOST_TEST(find_gaps(alone.configuration, alone.discretisation, 1e-6).empty());
}

BOOST_AUTO_TEST_CASE(fluid_is_where_the_side_of_every_component_says_so) {
  for (const Scene& scene :
       {random_bodies(7, 1.0), contained(random_bodies(8, 1.0)), contained(Scene{})}) {
    const Placed placed(scene);
    ComplexVector points(2000);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(-8.0, 8.0);
    for (Complex& point : points) point = {uniform(random), uniform(random)};
    std::vector<std::uint8_t> expected(2000, 1);
    for (std::size_t k = 0; k < placed.configuration.size(); ++k) {
      const Barycentric barycentric(placed.discretisation[k]->curve);
      const auto [position, orientation] = placed.configuration[k];
      for (Eigen::Index i = 0; i < points.size(); ++i) {
        const Complex local = (points[i] - position) * std::polar(1.0, -orientation);
        if (barycentric.side(local) <= 0.5) expected[static_cast<std::size_t>(i)] = 0;
      }
    }
    for (int threads : {1, 2}) {
      omp_set_num_threads(threads);
      BOOST_TEST(in_fluid(placed.configuration, placed.discretisation, points) == expected,
                 boost::test_tools::per_element());
    }
    omp_set_num_threads(1);
    BOOST_TEST(std::ranges::count(expected, 1) > 100);
    BOOST_TEST(std::ranges::count(expected, 0) > 100);
  }
}

}  // namespace stokesbook::test
