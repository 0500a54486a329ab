// Checks that the near targets are those of a test of every target against every curve, on one
// thread and on two.
#include "near_singular/near_targets.hpp"

#include <map>
#include <random>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "near_singular/near_field.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

std::shared_ptr<const CauchyCurve> cauchy(const Shape& shape, Index n, Side side) {
  return std::make_shared<CauchyCurve>(sample(shape, n, side));
}

// Bodies of several sizes lie on a jittered lattice, some of them near each other, in a container
// that is not convex.
std::vector<PlacedCurve> random_curves(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const std::vector<std::shared_ptr<const CauchyCurve>> shapes = {
      cauchy(Circle{0.3}, 16, Side::fluid_outside),
      cauchy(Ellipse{0.45, 0.1}, 32, Side::fluid_outside),
      cauchy(Star{0.35, 0.2, 3}, 48, Side::fluid_outside)};
  std::vector<PlacedCurve> curves{
      {cauchy(Star{8.0, 0.15, 5}, 128, Side::fluid_inside), {0.1, -0.2}, 0.4}};
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      const Complex place = Complex(i, j) + 0.03 * Complex{uniform(random), uniform(random)};
      curves.push_back({shapes[random() % 3], place, 3.0 * uniform(random)});
    }
  }
  return curves;
}

ComplexVector all_nodes(const std::vector<PlacedCurve>& curves) {
  ComplexVector nodes(node_offsets(curves).back());
  Index first = 0;
  for (const PlacedCurve& placed : curves) {
    const Curve curve = place(placed.curve(), placed.position, placed.orientation);
    nodes.segment(first, curve.size()) = curve.x;
    first += curve.size();
  }
  return nodes;
}

void test_against_all_pairs(const std::vector<PlacedCurve>& curves, const ComplexVector& targets,
                            Targets kind, double tolerance) {
  const std::vector<Index> offsets = node_offsets(curves);
  std::map<int, std::vector<NearTargets>> near;  // by number of threads
  for (int threads : {1, 2}) {
    omp_set_num_threads(threads);
    near[threads] = find_near_targets(curves, targets, kind, tolerance);
  }
  omp_set_num_threads(1);
  std::size_t found = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Complex turn = std::polar(1.0, -curves[k].orientation);
    std::vector<Index> expected;
    for (Index i = 0; i < targets.size(); ++i) {
      const bool own = kind == Targets::own_nodes && i >= offsets[k] && i < offsets[k + 1];
      const Complex local = (targets[i] - curves[k].position) * turn;
      if (!own && is_near(curves[k].curve(), local, tolerance)) expected.push_back(i);
    }
    BOOST_TEST(near[1][k].index == expected, boost::test_tools::per_element());
    BOOST_TEST(near[2][k].index == expected, boost::test_tools::per_element());
    BOOST_TEST((near[1][k].local.array() == near[2][k].local.array()).all());
    found += expected.size();
  }
  BOOST_TEST(found > 100u);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_nodes_are_near_as_in_a_test_of_all_pairs) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const std::vector<PlacedCurve> curves = random_curves(seed);
    for (double tolerance : {1e-4, 1e-8}) {
      test_against_all_pairs(curves, all_nodes(curves), Targets::own_nodes, tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_points_are_near_as_in_a_test_of_all_pairs) {
  const std::vector<PlacedCurve> curves = random_curves(4);
  ComplexVector grid(23 * 29), shuffled(500);
  for (Index i = 0; i < grid.size(); ++i) {
    grid[i] = {-4.0 + 0.35 * static_cast<double>(i % 23), -4.0 + 0.3 * static_cast<double>(i / 23)};
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-4.0, 4.0);
  for (Complex& point : shuffled) point = {uniform(random), uniform(random)};
  for (const ComplexVector& points : {grid, shuffled}) {
    test_against_all_pairs(curves, points, Targets::points, 1e-6);
  }
}
