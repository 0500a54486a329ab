// Checks that a curve through points of an ellipse is that ellipse, for any number of points and
// for both directions of traversal.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;

namespace {

ComplexVector ellipse_points(Index count, double start) {
  ComplexVector points(count);
  for (Index j = 0; j < count; ++j) {
    const double t =
        start + 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(count);
    points[j] = {2.0 * std::cos(t), std::sin(t)};
  }
  return points;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_ellipse_is_reproduced) {
  for (Index count : {4, 5, 7, 24, 25}) {
    for (Index n : {6, 24, 64, 250}) {
      const Curve curve = sample(NodalCurve{ellipse_points(count, 0.0), ""}, n, Side::fluid_inside);
      const Curve ellipse = sample(Ellipse{2.0, 1.0}, n, Side::fluid_inside);
      BOOST_TEST((curve.side == Side::fluid_inside));
      const double size = static_cast<double>(n);
      BOOST_TEST(largest(curve.x - ellipse.x) < 1e-14);
      BOOST_TEST(largest(curve.dx - ellipse.dx) < 1e-15 * size);
      BOOST_TEST(largest(curve.ddx - ellipse.ddx) < 1e-15 * size * size);
    }
  }
}

BOOST_AUTO_TEST_CASE(clockwise_points_give_a_counter_clockwise_curve) {
  for (Index count : {7, 24}) {
    const ComplexVector clockwise = ellipse_points(count, 0.3).reverse();
    const Curve curve = sample(NodalCurve{clockwise, ""}, 64, Side::fluid_outside);
    BOOST_TEST(std::abs(area(curve) - 2.0 * std::numbers::pi) < 1e-14);
    BOOST_TEST(curvatures(curve).minCoeff() > 0.0);
    // The normal points out of the fluid, and therefore into the body.
    BOOST_TEST(dot(normals(curve)[0], curve.x[0]) < 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_points_of_any_smooth_curve_resample_to_it) {
  const Shape star = Star{1.0, 0.2, 5};
  const ComplexVector points = sample(star, 48, Side::fluid_outside).x;
  const Curve fine = sample(NodalCurve{points, ""}, 400, Side::fluid_outside);
  const Curve exact = sample(star, 400, Side::fluid_outside);
  BOOST_TEST(largest(fine.x - exact.x) < 1e-14);
  BOOST_TEST(largest(fine.dx - exact.dx) < 1e-13);
  BOOST_TEST(largest(fine.ddx - exact.ddx) < 5e-11);
}
