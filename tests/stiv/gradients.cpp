// Checks the wrenches of rows: the derivative (10.9) against finite differences, balanced forces
// (10.10), and gaps that do not change when both components move together.
#include <cmath>
#include <map>

#include <boost/test/unit_test.hpp>

#include "steps.hpp"
#include "stiv/polygon_gaps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const ContactRules every{{0.1}, 1e-6, RowChoice::every};

// The steps are oblique and turning, with different shapes and sizes, also in a moving star-shaped
// container.
std::vector<Step> steps() {
  const auto ellipse = body(Ellipse{1.0, 0.4}, 200), star = body(Star{0.8, 0.25, 5}, 300);
  Step pair;
  pair.add(ellipse, {{{0.3, -0.2}, 0.4}, {0.5, 0.3}, 0.2});
  pair.add(star, {{{2.4, 0.5}, -0.3}, {-0.7, 0.1}, -0.3});
  Step fast = pair;
  for (RigidPath& path : fast.paths) path.displacement *= 6.0;
  Step bounded;
  bounded.add(star, {{{1.6, 0.2}, 0.3}, {0.9, 0.2}, 0.4});
  bounded.add(container(Star{3.0, 0.1, 5}, 600), {{{0.1, 0.0}, 0.2}, {-0.3, 0.1}, 0.1});
  return {pair, fast, bounded};
}

std::vector<ContactRow> rows(const Step& step) {
  std::vector<ContactRow> rows;
  for (const Contact& contact : violated(interferences(step, every))) {
    rows.insert(rows.end(), contact.rows.begin(), contact.rows.end());
  }
  return rows;
}

// Holds a motion of one component. The motion changes a row's gap by the wrench on the component.
struct Motion {
  std::size_t component;
  Complex shift;
  double turn;
};

double predicted(const ContactRow& row, const Motion& motion) {
  const Wrench& wrench = motion.component == 0 ? row.derivative.on_a : row.derivative.on_b;
  return dot(wrench.force, motion.shift) + wrench.torque * motion.turn;
}

std::vector<Motion> motions() {
  std::vector<Motion> all;
  for (std::size_t k = 0; k < 2; ++k) {
    all.push_back({k, {1.0, 0.0}, 0.0});
    all.push_back({k, {0.0, 1.0}, 0.0});
    all.push_back({k, {0.0, 0.0}, 1.0});
  }
  return all;
}

// Returns the edge that a row's vertex touches between the edge's ends, or -1 at a corner.
Eigen::Index touched_edge(const Step& step, const ContactRow& row) {
  const std::size_t a = row.key.vertex_of, b = row.key.polygon_of;
  const RelativePath path(step.paths[a], step.paths[b]);
  const Complex z = path.at(row.time)(step.shapes[a]->polygon.vertex(row.key.vertex));
  const Polygon& polygon = step.shapes[b]->polygon;
  const ClosestPoint closest = polygon.closest(z, INFINITY);
  const Complex from = polygon.vertex(closest.edge),
                to = polygon.vertex((closest.edge + 1) % polygon.size());
  const bool is_corner = closest.point == from || closest.point == to;
  return is_corner ? -1 : closest.edge;
}

struct Touch {
  double gap;
  Eigen::Index edge;
};

std::map<RowKey, Touch> touches_after(Step step, const Motion& motion, double size) {
  step.paths[motion.component].displacement += size * motion.shift;
  step.paths[motion.component].rotation += size * motion.turn;
  std::map<RowKey, Touch> touches;
  for (const ContactRow& row : rows(step)) touches[row.key] = {row.gap, touched_edge(step, row)};
  return touches;
}

}  // namespace

// The whole search is repeated for each difference, so that times and touched points also change.
BOOST_AUTO_TEST_CASE(derivatives_by_finite_differences) {
  constexpr double h = 1e-5;
  for (const Step& step : steps()) {
    std::size_t compared = 0;
    const std::vector<ContactRow> all = rows(step);
    for (const Motion& motion : motions()) {
      std::map<int, std::map<RowKey, Touch>> moved;
      for (int k : {-2, -1, 1, 2}) moved[k] = touches_after(step, motion, k * h);
      for (const ContactRow& row : all) {
        // The gap has no derivative if the touched edge changes. At corners the normal changes with
        // the path, which the derivative (10.9) neglects.
        const Eigen::Index edge = touched_edge(step, row);
        const bool stays = std::ranges::all_of(moved, [&](const auto& entry) {
          const auto found = entry.second.find(row.key);
          return found != entry.second.end() && found->second.edge == edge;
        });
        if (edge < 0 || !stays) continue;
        const auto gap = [&](int k) { return moved[k].at(row.key).gap; };
        const double slope = (8.0 * (gap(1) - gap(-1)) - (gap(2) - gap(-2))) / (12.0 * h);
        BOOST_TEST(std::abs(slope - predicted(row, motion)) < 1e-9);
        ++compared;
      }
    }
    BOOST_TEST(compared > 100u);
  }
}

BOOST_AUTO_TEST_CASE(gaps_do_not_change_when_both_components_move_together) {
  for (const Step& step : steps()) {
    const Complex centre_a = step.paths[0].at(1.0).position,
                  centre_b = step.paths[1].at(1.0).position;
    for (const ContactRow& row : rows(step)) {
      for (Complex about : {Complex{0.0, 0.0}, {3.0, -7.0}}) {
        // Turns both components about a point; the forces cover the shifts.
        const double turn =
            dot(row.derivative.on_a.force, perp(centre_a - about)) + row.derivative.on_a.torque +
            dot(row.derivative.on_b.force, perp(centre_b - about)) + row.derivative.on_b.torque;
        BOOST_TEST(std::abs(turn) < 1e-14);
      }
      BOOST_TEST(std::abs(row.derivative.on_a.force + row.derivative.on_b.force) == 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(forces_balance_about_the_start) {
  for (const Step& step : steps()) {
    const Complex centre_a = step.paths[0].start.position, centre_b = step.paths[1].start.position;
    const std::vector<ContactRow> all = rows(step);
    BOOST_TEST(all.size() > 5u);
    for (const ContactRow& row : all) {
      const auto& [on_a, on_b] = row.force;
      BOOST_TEST(std::abs(on_a.force + on_b.force) == 0.0);
      BOOST_TEST(std::abs(std::abs(on_a.force) - 1.0) < 1e-15);
      BOOST_TEST(on_a.force == row.normal);
      for (Complex about : {Complex{0.0, 0.0}, {3.0, -7.0}}) {
        const double torque = cross(centre_a - about, on_a.force) + on_a.torque +
                              cross(centre_b - about, on_b.force) + on_b.torque;
        BOOST_TEST(std::abs(torque) < 1e-14);
      }
      // Both forces act at the point of the row.
      BOOST_TEST(std::abs(on_a.torque - cross(row.point - centre_a, on_a.force)) < 1e-14);
      BOOST_TEST(std::abs(on_b.torque - cross(row.point - centre_b, on_b.force)) < 1e-14);
    }
  }
}

// The two forms differ by the components' displacements in the step.
BOOST_AUTO_TEST_CASE(both_forms_agree_for_small_steps) {
  const auto ellipse = body(Ellipse{1.0, 0.4}, 200), circle = body(Circle{0.5}, 200);
  const Pose fixed{{0.0, 0.0}, 0.4};
  // Finds the place at which the circle is at the separation.
  double low = 1.0, high = 2.0;
  while (high - low > 1e-13) {
    const double x = 0.5 * (low + high);
    const bool is_near = !polygon_gaps({ellipse, circle}, {fixed, {{x, 0.3}, 0.0}}, 0.1).empty();
    (is_near ? low : high) = x;
  }
  for (double size : {1e-1, 1e-2, 1e-3, 1e-4}) {
    Step step;
    step.add(ellipse, {fixed, size * Complex{1.0, 0.3}, size});
    step.add(circle, {{{high, 0.3}, 0.0}, -size * Complex{1.0, 0.1}, -size});
    const std::vector<Contact> contacts = violated(interferences(step, {{0.1}, 1e-8}));
    BOOST_REQUIRE(contacts.size() == 1u);
    const ContactRow& row = contacts[0].rows[0];
    const double difference =
        std::max({std::abs(row.force.on_a.force - row.derivative.on_a.force),
                  std::abs(row.force.on_a.torque - row.derivative.on_a.torque),
                  std::abs(row.force.on_b.torque - row.derivative.on_b.torque)});
    BOOST_TEST(difference < 3.0 * size);
    BOOST_TEST(difference > 0.01 * size);
  }
}
