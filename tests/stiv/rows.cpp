// Checks the rows of a contact: there is a single row where curves are curved, a row at both ends
// where curves are flat, and one row for each flank in a valley. Near pairs keep a row, and row
// names last from one iteration to the next.
#include <cmath>
#include <numbers>
#include <set>

#include <boost/test/unit_test.hpp>

#include "steps.hpp"
#include "stiv/polygon_gaps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(rows)

namespace {

constexpr double delta = 0.02, tolerance = 1e-3 * delta;

// Places a body above another body, and lowers it to a depth below the separation.
Interferences pressed(const Shape& below, const Shape& above, double between, double depth,
                      double tilt = 0.0, RowChoice rows = RowChoice::deepest) {
  const auto shape = [](const Shape& s) {
    return std::make_shared<ContactShape>(contact_shape(s, Side::fluid_outside, 0.05 * delta));
  };
  Step step;
  step.add(shape(below), {{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
  step.add(shape(above), {{{0.1, between + delta + 0.01}, tilt}, {0.0, -0.01 - depth}, 0.0});
  return interferences(step, {{delta}, tolerance, rows});
}

std::set<RowKey> keys(const Interferences& found) {
  std::set<RowKey> keys;
  for (const Contact& contact : found.contacts) {
    for (const ContactRow& row : contact.rows) keys.insert(row.key);
  }
  return keys;
}

}  // namespace

BOOST_AUTO_TEST_CASE(curved_contacts_have_one_row) {
  for (double depth : {-0.01, 1e-3, 0.01}) {
    const Interferences found = pressed(Circle{1.0}, Circle{0.5}, 1.495, depth);
    BOOST_REQUIRE(found.contacts.size() == 1u);
    BOOST_TEST(found.contacts[0].rows.size() == 1u);
    BOOST_TEST(found.contacts[0].is_violated() == (depth > 0.0));
  }
}

// Parallel slender ellipses touch along a stretch that is nearly straight: the deepest row is in
// the middle of the stretch, and all rows are near it.
BOOST_AUTO_TEST_CASE(slender_ellipses_side_by_side) {
  for (double depth : {-0.01, 1e-3, 5e-3}) {
    const Interferences found = pressed(Ellipse{1.0, 0.1}, Ellipse{1.0, 0.1}, 0.2, depth);
    BOOST_REQUIRE(found.contacts.size() == 1u);
    BOOST_TEST(found.contacts[0].is_violated() == (depth > 0.0));
    BOOST_TEST(found.contacts[0].rows.size() <= 3u);
    for (const ContactRow& row : found.contacts[0].rows) {
      BOOST_TEST(std::abs(row.point.real() - 0.05) < 0.2);
      BOOST_TEST(std::abs(row.normal - Complex{0.0, -1.0}) < 0.03);
    }
  }
}

// Flat sides have a row at either end, which prevents the body from rocking.
BOOST_AUTO_TEST_CASE(flat_sides_are_held_at_both_ends) {
  const Superellipse brick{1.0, 0.5, 20};
  for (double depth : {-0.01, 1e-3, 5e-3}) {
    const Interferences found = pressed(brick, brick, 1.0, depth);
    BOOST_REQUIRE(found.contacts.size() == 1u);
    const std::vector<ContactRow>& rows = found.contacts[0].rows;
    BOOST_TEST(rows.size() >= 2u);
    BOOST_TEST(rows.size() <= 4u);
    double left = INFINITY, right = -INFINITY;
    for (const ContactRow& row : rows) {
      left = std::min(left, row.point.real());
      right = std::max(right, row.point.real());
    }
    BOOST_TEST(left < -0.4);
    BOOST_TEST(right > 0.5);
  }
  // The tilted body stands on one corner.
  const Interferences tilted = pressed(brick, brick, 1.04, 0.01, 0.05);
  BOOST_REQUIRE(tilted.contacts.size() == 1u);
  BOOST_TEST(tilted.contacts[0].rows.size() == 1u);
}

// The sawtooth of polygons with different edges makes no additional rows.
BOOST_AUTO_TEST_CASE(edges_of_polygons_make_no_rows) {
  // A container is hardly larger than its disk: the gap is nearly the same all around.
  const double delta_wide = 0.1;
  const auto disk = body(Circle{1.0}, 61 * 2), wall = container(Circle{1.15}, 150);
  Step step;
  step.add(disk, {{{0.01, 0.0}, 0.1}, {0.001, 0.0}, 0.0});
  step.add(wall, {});
  const Interferences found = interferences(step, {{delta_wide}, 1e-3 * delta_wide});
  BOOST_REQUIRE(found.contacts.size() == 1u);
  BOOST_TEST(found.contacts[0].rows.size() <= 3u);
}

BOOST_AUTO_TEST_CASE(choices_of_rows) {
  const auto contact = [](RowChoice rows) {
    const std::vector<Contact> found =
        violated(pressed(Circle{1.0}, Ellipse{0.6, 0.3}, 1.29, 0.01, 0.0, rows));
    BOOST_REQUIRE(found.size() == 1u);
    return found[0];
  };
  const Contact deepest = contact(RowChoice::deepest), aggregate = contact(RowChoice::aggregate),
                every = contact(RowChoice::every);
  BOOST_TEST(deepest.volume == every.volume);
  BOOST_TEST(deepest.volume == aggregate.volume);
  BOOST_REQUIRE(aggregate.rows.size() == 1u);
  BOOST_TEST(every.rows.size() > 6u);
  // The deepest row is the deepest of all rows.
  double least = 0.0;
  for (const ContactRow& row : every.rows) {
    BOOST_TEST(row.gap < -tolerance);
    least = std::min(least, row.gap);
  }
  BOOST_TEST(least_gap({deepest}) == least);
  // The gap of the aggregate lies between this least gap and 0, and its forces balance as well.
  const ContactRow& mean = aggregate.rows[0];
  BOOST_TEST(mean.gap > least);
  BOOST_TEST(mean.gap < 0.0);
  BOOST_TEST(std::abs(mean.force.on_a.force + mean.force.on_b.force) < 1e-15);
  BOOST_TEST(std::abs(mean.force.on_a.force) < 1.0);
  BOOST_TEST((mean.key == deepest.rows[0].key));
}

// A small change of the step leaves the names of most rows unchanged.
BOOST_AUTO_TEST_CASE(keys_last_between_iterations) {
  const auto at = [](double depth) {
    return keys(pressed(Circle{1.0}, Ellipse{0.6, 0.3}, 1.29, depth));
  };
  BOOST_TEST(at(0.01).size() == 1u);
  BOOST_TEST((at(0.01) == at(0.010001)));
  BOOST_TEST((at(0.01) == at(0.002)));
  // A row stays where the contact is resolved.
  BOOST_TEST(at(-1e-6).size() == 1u);
}

// A tip of a star lies in a valley of another star: each flank is a contact of its own.
BOOST_AUTO_TEST_CASE(a_tip_in_a_valley) {
  const auto wide = body(Star{1.0, 0.45, 3}, 800), blunt = body(Star{0.5, 0.05, 3}, 300);
  const Complex valley = std::polar(1.0, std::numbers::pi / 3.0);
  // Turns a tip towards the valley.
  const auto pose = [&](double away) {
    return Pose{away * valley, std::numbers::pi / 3.0 + std::numbers::pi};
  };
  double low = 0.5, high = 2.5;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    const bool is_near = !polygon_gaps({wide, blunt}, {{}, pose(middle)}, delta).empty();
    (is_near ? low : high) = middle;
  }
  Step step;
  step.add(wide, {});
  step.add(blunt, {pose(high + 0.3), -(0.3 + 0.5 * delta) * valley, 0.0});
  const std::vector<Contact> contacts = violated(interferences(step, {{delta}, tolerance}));
  BOOST_TEST(contacts.size() == 2u);
  Complex sum{};
  for (const Contact& contact : contacts) {
    for (const ContactRow& row : contact.rows) sum += row.normal * std::conj(valley);
  }
  // The flanks push almost equally, so that the tip is pushed out along the valley.
  BOOST_TEST(std::abs(sum.imag()) < 0.05 * std::abs(sum));
  BOOST_TEST(sum.real() < 0.0);  // the normal is the one on the first component
}

// A pair may have a smaller separation than the others.
BOOST_AUTO_TEST_CASE(a_separation_of_one_pair) {
  const auto circle = body(Circle{0.5}, 128);
  Step step;
  for (int k = 0; k < 3; ++k) step.add(circle, {{{1.05 * k, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
  step.paths[0].displacement = 0.035;
  step.paths[2].displacement = -0.035;
  const auto violated_pairs = [&](const Separation& separation) {
    std::set<ComponentPair> pairs;
    for (const Contact& contact : violated(interferences(step, {separation, tolerance}))) {
      pairs.insert({contact.a, contact.b});
    }
    return pairs;
  };
  BOOST_TEST((violated_pairs({0.02}) == std::set<ComponentPair>{{0, 1}, {1, 2}}));
  BOOST_TEST((violated_pairs({0.02, {{{0, 1}, 0.01}}}) == std::set<ComponentPair>{{1, 2}}));
  BOOST_TEST((violated_pairs({0.02, {{{1, 2}, 0.01}}}) == std::set<ComponentPair>{{0, 1}}));
  // A pair's own separation cannot be wider than the separation of all.
  BOOST_TEST((violated_pairs({0.01, {{{1, 2}, 0.02}}}).empty()));
}

// Returns contacts of a disk's polygon with its copy, from the gaps of vertices from number 4 on.
std::vector<Contact> contacts_by_gaps(const std::vector<double>& gaps) {
  const auto coarse = body(Circle{1.0}, 32);
  BOOST_TEST(coarse->sag > 4.0 * tolerance);
  std::vector<VertexEvent> events;
  for (const double gap : gaps) {
    const Eigen::Index vertex = 4 + static_cast<Eigen::Index>(events.size());
    events.push_back({vertex, 20, 0.1, 1.0, gap, {-1.0, 0.0}, {-1.0, 0.0}});
  }
  const PathPair paths{0, 1, {{{0.0, 0.0}, 0.0}, {}, 0.0}, {{{2.0, 0.0}, 0.0}, {}, 0.0}};
  return connected_contacts({paths, *coarse, *coarse, events, {}, {}}, tolerance,
                            RowChoice::deepest);
}

// The depths of two violations differ by less than a sag. There is one minimum, but each violation
// has its own row.
BOOST_AUTO_TEST_CASE(every_contact_has_a_row) {
  const std::vector<Contact> contacts = contacts_by_gaps({-3 * tolerance, 0.0, -2 * tolerance});
  BOOST_REQUIRE(contacts.size() == 2u);
  for (const Contact& contact : contacts) {
    BOOST_TEST(contact.is_violated());
    BOOST_TEST(contact.rows.size() == 1u);
  }
}

// The first contact is flat, and the end of its support is the second contact's only row.
BOOST_AUTO_TEST_CASE(contacts_share_no_row) {
  const double t = tolerance;
  const std::vector<Contact> contacts =
      contacts_by_gaps({-2 * t, -3 * t, -2 * t, -2 * t, 0.0, -2 * t});
  BOOST_REQUIRE(contacts.size() == 2u);
  BOOST_REQUIRE(contacts[0].rows.size() == 2u);
  BOOST_TEST(contacts[0].rows[0].key.vertex == 4);
  BOOST_TEST(contacts[0].rows[1].key.vertex == 5);
  BOOST_REQUIRE(contacts[1].rows.size() == 1u);
  BOOST_TEST(contacts[1].rows[0].key.vertex == 9);
}

BOOST_AUTO_TEST_SUITE_END()
