// Checks that the side test of a resolved curve is right at every distance, on both sides.
#include <cmath>
#include <random>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "near_singular/cauchy.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

struct Case {
  Shape shape;
  Index n;
};
const std::vector<Case> cases = {{Circle{1.0}, 64},
                                 {Ellipse{1.0, 0.5}, 128},
                                 {Ellipse{1.0, 0.1}, 256},
                                 {Star{1.0, 0.3, 5}, 256}};

}  // namespace

BOOST_AUTO_TEST_CASE(random_points_from_rounding_to_three_radii_away) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> exponent(-12.0, 0.5);
  for (const auto& [shape, n] : cases) {
    // The shapes are star-shaped about the origin: a smaller multiple of a curve point lies inside.
    const Curve points = sample(shape, 2002, Side::fluid_outside);
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const CauchyCurve cauchy(sample(shape, n, side));
      const bool fluid_is_outside = side == Side::fluid_outside;
      int wrong = 0;
      for (Complex x : points.x) {
        const double distance = std::pow(10.0, exponent(generator));
        wrong += cauchy.in_fluid(x * (1.0 + distance)) == fluid_is_outside ? 0 : 1;
        wrong += cauchy.in_fluid(x / (1.0 + distance)) == fluid_is_outside ? 1 : 0;
      }
      BOOST_TEST(wrong == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(nodes_belong_to_the_fluid) {
  for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
    const Curve curve = sample(Star{1.0, 0.3, 5}, 256, side);
    const CauchyCurve cauchy(curve);
    for (Complex x : curve.x) BOOST_TEST(cauchy.in_fluid(x));
  }
}
