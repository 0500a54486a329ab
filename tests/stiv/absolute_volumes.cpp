// Checks the volume by absolute velocities (10.11), which depends on the observer, and the relative
// volume, which does not depend on the observer.
#include <boost/test/unit_test.hpp>

#include "steps.hpp"
#include "stiv/absolute_volume.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

// Circle a lies on the left, and circle b on the right, slightly shifted aside.
PathPair paths(double velocity_a, double velocity_b) {
  return {0,
          1,
          {{{0.0, 0.0}, 0.0}, {velocity_a, 0.0}, 0.0},
          {{{2.2, 0.2}, 0.0}, {velocity_b, 0.0}, 0.0}};
}

const ContactShapes& circles() {
  static const ContactShapes both{body(Circle{1.0}, 256), body(Circle{1.0}, 256)};
  return both;
}

AbsoluteVolume absolute(double velocity_a, double velocity_b) {
  return absolute_volume(
      pair_events(circles(), paths(velocity_a, velocity_b), {0.1, 1e-5, 0.4, 0.0}), 1e-5);
}

Contact relative(double velocity_a, double velocity_b) {
  const PathPair pair = paths(velocity_a, velocity_b);
  const std::vector<Contact> contacts =
      violated(interferences({circles(), {pair.path_a, pair.path_b}}, {{0.1}, 1e-5}));
  BOOST_REQUIRE(contacts.size() == 1u);
  return contacts[0];
}

}  // namespace

// All three cases have the same relative motion: b approaches a by 0.4.
BOOST_AUTO_TEST_CASE(one_relative_motion_seen_by_three_observers) {
  const AbsoluteVolume together = absolute(0.2, -0.2), hit = absolute(0.4, 0.0),
                       chase = absolute(0.8, 0.4);
  // The motions are symmetric: the forces are opposite.
  const Complex sum = together.force.on_a.force + together.force.on_b.force;
  BOOST_TEST(std::abs(sum) < 1e-3 * std::abs(together.force.on_a.force));
  BOOST_TEST(together.force.on_a.force.real() < 0.0);
  // B at rest is hit and feels no force: the forces are not opposite.
  BOOST_TEST(hit.force.on_a.force.real() < 0.0);
  BOOST_TEST(std::abs(hit.force.on_b.force) == 0.0);
  // A overtakes B, and B is pulled towards A: both bodies are pushed back.
  BOOST_TEST(chase.force.on_a.force.real() < 0.0);
  BOOST_TEST(chase.force.on_b.force.real() < 0.0);
  BOOST_TEST(std::abs(chase.force.on_b.force - chase.force.on_a.force) <
             0.05 * std::abs(chase.force.on_a.force));
  // The volume depends on the observer.
  BOOST_TEST(chase.volume < 1.5 * hit.volume);
}

BOOST_AUTO_TEST_CASE(without_contact_there_is_no_volume) {
  BOOST_TEST(absolute(-0.2, 0.2).volume == 0.0);
}

BOOST_AUTO_TEST_CASE(the_relative_volume_does_not_see_them) {
  const Contact together = relative(0.2, -0.2);
  for (const Contact& other : {relative(0.4, 0.0), relative(0.8, 0.4), relative(-7.0, -7.4)}) {
    BOOST_TEST(std::abs(other.volume / together.volume - 1.0) < 1e-12);
    BOOST_REQUIRE(other.rows.size() == together.rows.size());
    for (std::size_t i = 0; i < other.rows.size(); ++i) {
      const ContactRow &row = other.rows[i], &same = together.rows[i];
      BOOST_TEST(std::abs(row.gap - same.gap) < 1e-13);
      BOOST_TEST(std::abs(row.force.on_a.force - same.force.on_a.force) < 1e-12);
      BOOST_TEST(std::abs(row.force.on_a.force + row.force.on_b.force) == 0.0);
    }
  }
}

// Compares with differences of the volume at frozen contact times.
BOOST_AUTO_TEST_CASE(the_derivative_with_frozen_times) {
  const PairEvents events = pair_events(circles(), paths(0.5, -0.1), {0.1, 1e-5, 0.4, 0.0});
  const auto volume = [&](Complex shift, double turn) {
    PairEvents moved = events;
    moved.paths.path_a.displacement += shift;
    moved.paths.path_a.rotation += turn;
    return absolute_volume(moved, 1e-5).volume;
  };
  constexpr double h = 1e-6;
  const Wrench wrench = absolute_volume(events, 1e-5).force.on_a;
  BOOST_TEST(std::abs((volume(h, 0.0) - volume(-h, 0.0)) / (2.0 * h) - wrench.force.real()) < 1e-9);
  BOOST_TEST(std::abs((volume(h * imaginary, 0.0) - volume(-h * imaginary, 0.0)) / (2.0 * h) -
                      wrench.force.imag()) < 1e-9);
}
