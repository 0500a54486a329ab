// Checks the double layer of a rigid motion v (02.7), (03.3) on a closed curve: v inside a body,
// v/2 on the curve, 0 in the fluid, and for an enclosing wall -v, -v/2 and 0.
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using test::largest;

namespace {

struct Case {
  Shape shape;
  Eigen::Index n;
};
// These node counts resolve the kernel to rounding: the error for ellipses is m^N with
// m = (a - b) / (a + b).
const std::vector<Case> cases = {
    {Circle{0.7}, 16}, {Ellipse{2.0, 1.0}, 40}, {Ellipse{0.4, 1.2}, 64}, {Star{1.0, 0.2, 5}, 200}};

// Returns a rigid motion about a point that is not the curve's centre.
ComplexVector rigid_motion(const ComplexVector& x) {
  return (Complex{0.6, -0.8} + 1.5 * imaginary * (x.array() - Complex{0.3, 0.2})).matrix();
}

}  // namespace

BOOST_AUTO_TEST_CASE(on_the_curve) {
  for (const Case& c : cases) {
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const Curve curve = sample(c.shape, c.n, side);
      const ComplexVector v = rigid_motion(curve.x);
      const Eigen::VectorXd dv = double_layer_matrix(curve) * interleaved(v);
      BOOST_TEST(largest(deinterleaved(dv) + 0.5 * curve.sign() * v) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(off_the_curve) {
  // The targets are far enough from 600 nodes for the trapezoid rule: N |Im s| > 36 (02.15).
  const ComplexVector inside = ComplexVector{{Complex{0.1, 0.05}, Complex{-0.2, 0.1}}};
  const ComplexVector outside = ComplexVector{{Complex{2.5, 0.5}, Complex{-0.4, -3.0}}};
  for (const Case& c : cases) {
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const Curve curve = sample(c.shape, 600, side);
      const StressletSum layer({curve});
      const ComplexVector v = rigid_motion(curve.x);
      BOOST_TEST(largest(layer(inside, v) + curve.sign() * rigid_motion(inside)) < 1e-13);
      BOOST_TEST(largest(layer(outside, v)) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_residual_measures_resolution) {
  // The error of D v is an aliasing error from modes N apart, which is m^N for an ellipse. The
  // residual must decay at the same rate.
  const double m = 5.0 / 7.0;
  double previous = 0.0;
  for (Eigen::Index n : {24, 32, 40, 48}) {
    const double residual =
        rigid_motion_residual(sample(Ellipse{6.0, 1.0}, n, Side::fluid_outside));
    if (previous > 0.0)
      BOOST_TEST(std::abs(std::log(residual / previous) / (8.0 * std::log(m)) - 1.0) < 0.15);
    previous = residual;
  }
  for (const Case& c : cases) {
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      BOOST_TEST(rigid_motion_residual(sample(c.shape, c.n, side)) < 1e-14);
      BOOST_TEST(rigid_motion_residual(place(sample(c.shape, c.n, side), {1e3, -2e3}, 0.4)) <
                 1e-11);
    }
  }
  BOOST_TEST(rigid_motion_residual(sample(Star{1.0, 0.2, 5}, 24, Side::fluid_outside)) > 1e-3);
}
