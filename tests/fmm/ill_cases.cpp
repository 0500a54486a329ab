// Checks the FMM for coincident points, for no points, at any scale, and for targets on and next to
// nodes.
#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;
using test::relative_error;

namespace {

// p / 2^p bounds the truncation error of one translation (08.9) and is below 5e-14, so the test
// does not rely on errors that cancel.
constexpr int ample_order = 50;
constexpr double bound = 1e-12;

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_to_sum) {
  const Fmm nothing({}, {}, {ample_order, 10});
  BOOST_TEST(nothing.velocity(ComplexVector(0)).rows() == 0);
  const ComplexVector targets = random_vector(100, 1);
  const Fmm at_targets({}, {}, targets, {5, 3});
  BOOST_TEST(at_targets.velocity(ComplexVector(0)).norm() == 0.0);
  BOOST_TEST(at_targets.derivatives(ComplexVector(0)).size() == 100);
  const std::vector<Curve> curves = test::ellipses(2, 64);
  const Fmm nowhere(curves, random_vector(9, 2), ComplexVector(0), {5, 3});
  BOOST_TEST(nowhere.velocity(random_vector(256, 3)).rows() == 0);
}

BOOST_AUTO_TEST_CASE(one_body_one_node_one_force) {
  const ComplexVector targets = (3.0 * random_vector(300, 1).array() + Complex{0.1, 0.2}).matrix();
  for (const Index n : {1, 64, 1000}) {
    const std::vector<Curve> curves = {test::cloud(random_vector(n, 4), 1e-3)};
    const StressletSum sum(curves);
    const ComplexVector density = random_vector(n, 5);
    const Fmm at_targets(curves, {}, targets, {ample_order, 10});
    BOOST_TEST(relative_error(at_targets.velocity(density), sum(targets, density)) < bound);
    if (n == 1) {
      BOOST_TEST(Fmm(curves, {}, {ample_order, 10}).velocity(density).norm() == 0.0);
    } else {
      BOOST_TEST(relative_error(Fmm(curves, {}, {ample_order, 10}).velocity(density),
                                sum(density)) < bound);
    }
  }
  // The box of a single source has no extent. The source lies among its targets, or far from them.
  const Complex force{0.3, -0.4};
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const Complex place : {Complex{0.123, 0.234}, Complex{60.0, 50.0}}) {
      const ComplexVector point{{scale * place}}, around = scale * targets;
      const Fmm fmm({}, point, around, {ample_order, 10});
      const ComplexVector found =
          fmm.velocity({ComplexVector(0), ComplexVector{{force}}, Eigen::VectorXd{{scale}}});
      ComplexVector exact(around.size());
      for (Index i = 0; i < around.size(); ++i) {
        exact[i] = stokeslet(around[i] - point[0], force, 1.0, 1.0) +
                   rotlet(around[i] - point[0], scale, 1.0);
      }
      BOOST_TEST(relative_error(found, exact) < bound);
    }
  }
}

BOOST_AUTO_TEST_CASE(any_length) {
  const ComplexVector density = random_vector(25 * 64, 3);
  for (const double length : {1e-6, 1e6}) {
    std::vector<Curve> curves = test::ellipses(5, 64);
    for (Curve& curve : curves) {
      curve.x *= length;
      curve.dx *= length;
      curve.ddx *= length;
    }
    const Fmm fmm(curves, {}, {ample_order, 20});
    const StressletSum sum(curves);
    BOOST_TEST(relative_error(fmm.velocity(density), sum(density)) < bound);
    BOOST_TEST(relative_error(fmm.derivatives(density),
                              sum.derivatives(all_nodes(curves), density)) < 100.0 * bound);
  }
}

// All nodes coincide, or many nodes lie at each place, so all points of a leaf lie at one place.
BOOST_AUTO_TEST_CASE(coincident_nodes) {
  const ComplexVector density = random_vector(600, 3);
  for (const Index places : {1, 2, 100}) {
    ComplexVector points(600);
    for (Index i = 0; i < 600; ++i) points[i] = random_vector(places, 6)[i % places];
    for (const double weight : {1e-12, 1e-2}) {
      const std::vector<Curve> curves = {test::cloud(points, weight)};
      const ComplexVector exact = StressletSum(curves)(density);
      const ComplexVector found = Fmm(curves, {}, {ample_order, 4}).velocity(density);
      BOOST_TEST((found - exact).norm() <= bound * exact.norm());
    }
  }
}

// Expansions never treat a pair whose distance the kernel bounds from below. The sum equals the
// direct sum for leaves of one point, for nodes with large weights, and for targets next to and on
// nodes.
BOOST_AUTO_TEST_CASE(targets_within_half_a_weight) {
  const ComplexVector nodes = random_vector(150, 1), density = random_vector(150, 2);
  ComplexVector targets(150);
  for (const double weight : {1e-8, 1e-4, 1e-2, 0.3}) {
    const std::vector<Curve> curves = {test::cloud(nodes, weight)};
    for (const double distance : {0.0, 0.1, 0.49, 0.51, 2.0}) {
      for (Index i = 0; i < 150; ++i) {
        targets[i] = nodes[i] + std::polar(distance * weight, static_cast<double>(i));
      }
      const StressletSum sum(curves);
      const ComplexVector exact = sum(targets, density);
      const auto exact_derivatives = sum.derivatives(targets, density);
      for (const Index leaf_size : {1, 3, 50, 1000}) {
        const Fmm fmm(curves, {}, targets, {ample_order, leaf_size});
        BOOST_TEST(relative_error(fmm.velocity(density), exact) < bound);
        BOOST_TEST(relative_error(fmm.derivatives(density), exact_derivatives) < 100.0 * bound);
      }
    }
  }
}
