// Checks the volume (10.6), (10.7) of two circles that end too near, and where the volume is zero.
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(volumes)

namespace {

constexpr double radius = 0.5;

// Returns the volume of two circles that approach from a wide gap to a depth p.
double volume(double delta, double depth, Eigen::Index m) {
  const double travel = 0.2;
  Step step;
  step.add(body(Circle{radius}, m), {{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
  step.add(body(Circle{radius}, m),
           {{{2.0 * radius + delta + travel - depth, 0.0}, 0.0}, {-travel, 0.0}, 0.0});
  const std::vector<Contact> contacts = violated(interferences(step, {{delta}, 1e-4 * depth}));
  BOOST_REQUIRE(contacts.size() == 1u);
  BOOST_TEST(least_gap(contacts) == -depth, boost::test_tools::tolerance(1e-9));
  return contacts[0].volume;
}

}  // namespace

// The vertices of both circles count. At a distance s from the axis the gap's depth is
// p - s^2 (1/a + 1/(a + delta))/2.
BOOST_AUTO_TEST_CASE(the_volume_of_circles_grows_as_depth_to_three_halves) {
  for (double delta : {1e-3, 0.05}) {
    const double curvature = 0.5 * (1.0 / radius + 1.0 / (radius + delta));
    for (double depth : {1e-3, 1e-4, 1e-5}) {
      const double exact = -2.0 * 4.0 / 3.0 * std::pow(depth, 1.5) / std::sqrt(curvature);
      BOOST_TEST(volume(delta, depth, 16384) == exact, boost::test_tools::tolerance(3e-3));
    }
  }
  // If the curvature of the separation is neglected, the volume is 4/3 sqrt(a) p^(3/2) for each
  // circle (10.7).
  const double published = -2.0 * 4.0 / 3.0 * std::sqrt(radius) * std::pow(1e-4, 1.5);
  BOOST_TEST(volume(1e-3, 1e-4, 16384) == published, boost::test_tools::tolerance(5e-3));
}

BOOST_AUTO_TEST_CASE(contacts_that_are_not_violated_have_no_volume) {
  const auto circle = body(Circle{radius}, 64);
  Step step;
  step.add(circle, {{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
  step.add(circle, {{{1.5, 0.0}, 0.0}, {-0.35, 0.0}, 0.0});
  const Interferences found = interferences(step, {{0.1}, 1e-4});
  BOOST_TEST(found.admits_step());
  BOOST_REQUIRE(found.contacts.size() == 1u);
  BOOST_TEST(found.contacts[0].volume == 0.0);
  BOOST_TEST(!found.contacts[0].is_violated());
  BOOST_REQUIRE(found.contacts[0].rows.size() == 1u);
  BOOST_TEST(found.contacts[0].rows[0].gap == 0.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(found.contacts[0].rows[0].time == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
