// Tests the measure of the imbalance of contact forces: it contains the sum that remains, and does
// not depend on the origin (chapter 12).

#include "scenes.hpp"
#include "suspension/contact/contact.hpp"

namespace stokesbook::test {

namespace {

ContactShapes disks(std::size_t count, double radius) {
  return {count, std::make_shared<const ContactShape>(
                     contact_shape(Circle{radius}, Side::fluid_outside, 1e-2))};
}

// Two disks push each other at their contact; a third disk touches nothing.
struct Touching {
  Configuration configuration{{{-1.0, 0.0}, 0.3}, {{1.0, 0.0}, 0.0}, {{70.0, 20.0}, 0.0}};
  Eigen::VectorXd force{{-2.0, 0.7, 0.7, 2.0, -0.7, 0.7, 0.0, 0.0, 0.0}};

  Imbalance about(Complex origin) const {
    Configuration moved = configuration;
    for (Pose& pose : moved) pose.position -= origin;
    return imbalance(force, moved, disks(3, 1.0));
  }
};

const std::vector<Complex> origins{{}, {-1.0, 0.0}, {0.3, 0.4}, {3e4, -5e4}};

}  // namespace

BOOST_AUTO_TEST_SUITE(imbalances)

BOOST_AUTO_TEST_CASE(forces_that_balance_leave_rounding) {
  for (const Complex origin : origins) {
    const auto [force, torque] = Touching{}.about(origin);
    BOOST_TEST(force == 0.0);
    BOOST_TEST(torque < 1e-15 * (1.0 + std::abs(origin)));
  }
}

BOOST_AUTO_TEST_CASE(what_is_left_over_is_the_same_from_everywhere) {
  const double largest = std::hypot(2.0, 0.7);
  for (const Complex origin : origins) {
    Touching turned;
    turned.force[2] += 0.1;  // the lever is the distance 1 plus the radius 1
    BOOST_TEST(turned.about(origin).force == 0.0);
    BOOST_TEST(turned.about(origin).torque == 0.1 / (2.0 * largest),
               boost::test_tools::tolerance(1e-10));
    Touching pushed;
    pushed.force[4] -= 0.1;
    BOOST_TEST(pushed.about(origin).force == 0.1 / std::hypot(2.0, 0.8),
               boost::test_tools::tolerance(1e-13));
    BOOST_TEST(pushed.about(origin).torque == 0.1 / (2.0 * std::hypot(2.0, 0.8)),
               boost::test_tools::tolerance(1e-10));
  }
}

BOOST_AUTO_TEST_CASE(contacts_that_cancel_but_for_their_torque_are_measured_by_it) {
  const Eigen::VectorXd couple{{1e-17, 0.0, 0.6, 0.0, 0.0, -0.6}};
  const Configuration one_in_another{{{}, 0.0}, {{}, 0.0}};
  const auto [force, torque] = imbalance(couple, one_in_another, disks(2, 1.5));
  BOOST_TEST(force < 1e-16);
  BOOST_TEST(torque == 0.0);
}

BOOST_AUTO_TEST_CASE(no_forces_leave_nothing) {
  const auto [force, torque] = imbalance(Eigen::VectorXd::Zero(6), {{}, {}}, disks(2, 1.0));
  BOOST_TEST(force == 0.0);
  BOOST_TEST(torque == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
