// Checks that the sum turns, moves and scales with its points, and is linear.
#include <boost/test/unit_test.hpp>

#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;
using test::relative_error;

namespace {

constexpr double sum_tolerance = 1e-10;

struct Setting {
  std::vector<Curve> curves = test::ellipses(4, 64);
  ComplexVector points = (5.0 * random_vector(500, 1).array() + Complex{4.0, 4.0}).matrix();
  ComplexVector density = random_vector(16 * 64, 2), force = random_vector(500, 3);
  Eigen::VectorXd torque = random_vector(500, 4).real();

  ComplexVector velocity() const {
    return Fmm(curves, points, FmmSettings::for_tolerance(sum_tolerance))
        .velocity({density, force, torque});
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(turned_and_moved) {
  const Setting before;
  const Complex turn = std::polar(1.0, 0.7), shift{-13.0, 5.0};
  Setting after = before;
  for (Curve& curve : after.curves) curve = place(curve, shift, 0.7);
  after.points = (turn * before.points.array() + shift).matrix();
  after.density = turn * before.density;
  after.force = turn * before.force;
  BOOST_TEST(relative_error(after.velocity(), turn * before.velocity()) < 2.0 * sum_tolerance);
}

// A change of the length keeps the velocities of nodes, and adds a logarithm to those of forces.
// The torques are multiplied by the length, which keeps their velocities.
BOOST_AUTO_TEST_CASE(scaled_by_a_power_of_two) {
  const Setting before;
  constexpr double length = 8.0;  // a power of two: the same boxes, the same rounding
  Setting after = before;
  for (Curve& curve : after.curves) {
    curve.x *= length;
    curve.dx *= length;
    curve.ddx *= length;
  }
  after.points *= length;
  after.torque *= length;
  const Complex drift = -std::log(length) / (4.0 * std::numbers::pi) * before.force.sum();
  const ComplexVector expected = (before.velocity().array() + drift).matrix();
  BOOST_TEST(relative_error(after.velocity(), expected) < 1e-13);
}

BOOST_AUTO_TEST_CASE(linear) {
  const Setting first;
  Setting second = first, both = first;
  second.density = random_vector(16 * 64, 5);
  second.force = random_vector(500, 6);
  second.torque = random_vector(500, 7).real();
  both.density = 2.0 * first.density - 3.0 * second.density;
  both.force = 2.0 * first.force - 3.0 * second.force;
  both.torque = 2.0 * first.torque - 3.0 * second.torque;
  const ComplexVector expected = 2.0 * first.velocity() - 3.0 * second.velocity();
  BOOST_TEST(relative_error(both.velocity(), expected) < 1e-13);
}

// A constant density adds a translation within closed curves: D[const] is 0 outside (02.7).
BOOST_AUTO_TEST_CASE(constant_densities_of_bodies_leave_the_fluid_at_rest) {
  const std::vector<Curve> curves = test::ellipses(4, 256);
  const ComplexVector targets{{Complex{1.25, 1.25}, Complex{-3.0, 4.0}, Complex{20.0, 1.0}}};
  const Fmm fmm(curves, {}, targets, FmmSettings::for_tolerance(1e-12));
  BOOST_TEST(fmm.velocity(ComplexVector::Constant(16 * 256, {1.0, -2.0})).norm() < 1e-11);
}
