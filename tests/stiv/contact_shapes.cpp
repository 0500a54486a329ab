// Checks polygons that replace curves: the sag (10.1) is within its limit, the polygons have few
// vertices, and the error of a gap is less than two sags.
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "stiv/contact_shape.hpp"
#include "support/vectors.hpp"
#include "trapezoid/shape.hpp"

using namespace stokesbook;
using Eigen::Index;

BOOST_AUTO_TEST_SUITE(contact_shapes)

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Shape> shapes() {
  return {Circle{0.7}, Ellipse{1.0, 0.1}, Star{1.0, 0.3, 5}, Superellipse{1.0, 0.5, 6},
          NodalCurve{sample(Star{1.0, 0.2, 3}, 64, Side::fluid_outside).x, {}}};
}

// Returns the largest distance of the curve from the polygon, at a grid of parameters.
double farthest(const Shape& shape, const Polygon& polygon) {
  const Parametrisation point = parametrisation(shape);
  double distance = 0.0;
  constexpr int places = 10007;
  for (int i = 0; i < places; ++i) {
    const Complex z = point(2.0 * std::numbers::pi * i / places).value;
    distance = std::max(distance, std::abs(polygon.closest(z, infinity).distance));
  }
  return distance;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_curve_is_within_the_sag_of_the_polygon) {
  for (const Shape& shape : shapes()) {
    for (double limit : {1e-2, 1e-3, 1e-4, 1e-6}) {
      const ContactShape contact = contact_shape(shape, Side::fluid_outside, limit);
      BOOST_TEST(contact.sag <= limit);
      const double found = farthest(shape, contact.polygon);
      BOOST_TEST(found <= 1.05 * contact.sag);
      // The polygon has no more vertices than the limit requires.
      if (contact.polygon.size() > 40) BOOST_TEST(found > 0.8 * limit);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_sag_of_a_circle) {
  for (Index n : {16, 64, 1024}) {
    const double exact = 1.0 - std::cos(std::numbers::pi / static_cast<double>(n));
    const double found = sag(sample(Circle{1.0}, n, Side::fluid_outside));
    BOOST_TEST(std::abs(found / exact - 1.0) < 1.0 / static_cast<double>(n * n));
  }
  // The published polygon has 32 nodes: the sags of two circles together are the separation 0.05 h.
  const Curve published = sample(Circle{1.0}, 32, Side::fluid_outside);
  BOOST_TEST(2.0 * sag(published) / (2.0 * std::numbers::pi / 32.0) == 0.049,
             boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(weights_are_lengths_of_the_polygon) {
  const ContactShape star = contact_shape(sample(Star{1.0, 0.3, 5}, 512, Side::fluid_outside));
  const Curve fine = sample(Star{1.0, 0.3, 5}, 512, Side::fluid_outside);
  BOOST_TEST(std::abs(star.weights.sum() / perimeter(fine) - 1.0) < 1e-4);
  BOOST_TEST((star.weights - weights(fine)).cwiseAbs().maxCoeff() < 1e-3 * star.weights.maxCoeff());
  BOOST_TEST(star.radius == bounding_radius(fine, 0.0));
}

// Polygons overestimate the gap of two circles, by less than the two sags.
BOOST_AUTO_TEST_CASE(gaps_of_polygons_bound_those_of_curves) {
  const ContactShape circle = contact_shape(Circle{1.0}, Side::fluid_outside, 1e-3);
  const ComplexVector turns = test::random_vector(200, 1);
  for (Complex turn : turns) {
    turn /= std::abs(turn);
    double gap = infinity;
    for (Complex x : circle.polygon.vertices()) {
      gap = std::min(gap, circle.polygon.closest(x + 2.1 * turn, infinity).distance);
    }
    BOOST_TEST(gap > 0.1 - 1e-14);
    BOOST_TEST(gap < 0.1 + 2.0 * circle.sag);
  }
}

BOOST_AUTO_TEST_CASE(a_sag_that_is_not_positive_is_refused) {
  for (double limit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_THROW(contact_shape(Circle{1.0}, Side::fluid_outside, limit),
                      std::invalid_argument);
  }
}

BOOST_AUTO_TEST_SUITE_END()
