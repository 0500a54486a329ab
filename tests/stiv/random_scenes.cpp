// Checks crowds on random paths by brute force, which follows all pairs of vertices and edges
// through many instants of the step: the search misses no contact, reports no false contact, and
// finds the first contact first.
#include <cmath>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(random_scenes)

namespace {

constexpr double separation = 0.05, tolerance = 1e-4 * separation;

// Returns the least unsigned distance of one polygon's vertices from all edges of the other
// polygon. Plain numbers, because tests are not optimised where sanitizers watch.
double least_distance(const Step& step, std::size_t a, std::size_t b, double tau) {
  struct Edge {
    double x, y, dx, dy, squared_length;
  };
  const ComplexVector& corners = step.shapes[b]->polygon.vertices();
  std::vector<Edge> edges;
  Complex before = corners[corners.size() - 1];
  for (const Complex corner : corners) {
    const Complex edge = corner - before;
    edges.push_back({before.real(), before.imag(), edge.real(), edge.imag(), std::norm(edge)});
    before = corner;
  }
  const RelativeFrame frame = RelativePath(step.paths[a], step.paths[b]).at(tau);
  double least = INFINITY;
  for (const Complex vertex : step.shapes[a]->polygon.vertices()) {
    const Complex moved = frame(vertex);
    const double x = moved.real(), y = moved.imag();
    for (const Edge& edge : edges) {
      const double along = (x - edge.x) * edge.dx + (y - edge.y) * edge.dy;
      double fraction = along / edge.squared_length;
      if (fraction < 0.0) fraction = 0.0;
      if (fraction > 1.0) fraction = 1.0;
      const double across_x = x - edge.x - fraction * edge.dx;
      const double across_y = y - edge.y - fraction * edge.dy;
      const double squared = across_x * across_x + across_y * across_y;
      if (squared < least) least = squared;
    }
  }
  return std::sqrt(least);
}

double distance(const Step& step, const ComponentPair& pair, double tau) {
  return std::min(least_distance(step, pair.first, pair.second, tau),
                  least_distance(step, pair.second, pair.first, tau));
}

double speed_bound(const Step& step, const ComponentPair& pair) {
  const auto [a, b] = pair;
  return std::max(RelativePath(step.paths[a], step.paths[b]).speed_bound(step.shapes[a]->radius),
                  RelativePath(step.paths[b], step.paths[a]).speed_bound(step.shapes[b]->radius));
}

// Returns the first instant of a fine grid at which a pair is nearer than the separation, or 2 if
// there is no such instant. Skips instants at which the pair is certainly apart.
double first_instant(const Step& step, const ComponentPair& pair, double grid) {
  const double speed = speed_bound(step, pair);
  for (double tau = 0.0; tau <= 1.0;) {
    const double d = distance(step, pair, tau);
    if (d < separation) return tau;
    tau += grid * std::max(1.0, std::floor((d - separation) / (speed * grid)));
  }
  return 2.0;
}

struct Tally {
  std::size_t near = 0, violated = 0, passed = 0, later = 0, contact_free = 0;
};

void compare(const Step& step, Tally& tally) {
  const Interferences found = interferences(step, {{separation}, tolerance, RowChoice::every});
  constexpr double grid = 1e-3;
  for (std::size_t b = 0; b < step.shapes.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const ComponentPair pair{a, b};
      const double speed = speed_bound(step, pair);
      const double instant = first_instant(step, pair, grid);
      const double end = distance(step, pair, 1.0);
      std::vector<Contact> contacts;
      for (const Contact& contact : violated(found)) {
        if (contact.a == a && contact.b == b) contacts.push_back(contact);
      }
      if (instant > 1.0) {
        // The pair is not near at any instant. There is no contact, except for events between
        // instants.
        ++tally.contact_free;
        if (!contacts.empty()) {
          const double least = distance(step, pair, first_time(contacts));
          BOOST_TEST(least < separation + 1.01 * tolerance);
          BOOST_TEST(least > separation - speed * grid);
        }
        continue;
      }
      ++tally.near;
      if (contacts.empty()) {
        // The pair has come near and left. The step is allowed if the pair is apart at the end.
        BOOST_TEST(end > separation - 1.01 * tolerance);
        ++tally.passed;
        continue;
      }
      ++tally.violated;
      // The first contact is at the first instant, except for vertices that come near and leave
      // again.
      const double time = first_time(contacts);
      if (time > instant) {
        ++tally.later;
        continue;
      }
      if (time == 0.0) continue;
      const double at_contact = distance(step, pair, time);
      BOOST_TEST(at_contact < separation + 1.01 * tolerance);
      BOOST_TEST(at_contact > separation - speed * grid);
    }
  }
}

void compare_crowds(unsigned seeds) {
  Tally tally;
  for (double travel : {0.1, 0.5, 3.0}) {
    for (unsigned seed = 1; seed <= seeds; ++seed) compare(random_step(8, seed, travel), tally);
  }
  BOOST_TEST_MESSAGE("near " << tally.near << ", violated " << tally.violated << ", passed "
                             << tally.passed << ", later " << tally.later << ", contact-free "
                             << tally.contact_free);
  BOOST_TEST(tally.violated > 6 * seeds);
  BOOST_TEST(tally.contact_free > 12 * seeds);
  BOOST_TEST(tally.passed < tally.violated / 4);
}

void compare_containers(unsigned seeds) {
  Tally tally;
  for (double travel : {0.3, 3.0}) {
    for (unsigned seed = 1; seed <= seeds; ++seed)
      compare(random_step(6, seed, travel, true), tally);
  }
  BOOST_TEST_MESSAGE("near " << tally.near << ", violated " << tally.violated << ", passed "
                             << tally.passed << ", later " << tally.later << ", contact-free "
                             << tally.contact_free);
  BOOST_TEST(tally.violated > 5 * seeds / 3);
  BOOST_TEST(tally.contact_free > 8 * seeds);
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_missed_in_crowds_and_containers) {
  compare_crowds(2);
  compare_containers(1);
}

BOOST_AUTO_TEST_CASE(nothing_is_missed_in_many_crowds_and_containers,
                     *boost::unit_test::label("full")) {
  compare_crowds(8);
  compare_containers(6);
}

// Checks by the independent test of the end that the components are apart after an admitted step.
BOOST_AUTO_TEST_CASE(admitted_steps_end_apart) {
  std::size_t admitted = 0, refused = 0;
  for (double travel : {0.02, 0.1, 0.5, 2.0}) {
    for (unsigned seed = 20; seed < 40; ++seed) {
      const Step step = random_step(5, seed, travel, seed % 2 == 0);
      const Interferences found = interferences(step, {{separation}, tolerance});
      std::vector<Pose> ends;
      for (const RigidPath& path : step.paths) ends.push_back(path.at(1.0));
      const bool is_apart = polygon_gaps(step.shapes, ends, separation - 1.001 * tolerance).empty();
      for (const Contact& contact : found.contacts) BOOST_TEST(!contact.rows.empty());
      if (found.admits_step()) {
        BOOST_TEST(is_apart);
        ++admitted;
      } else {
        ++refused;
      }
      if (!is_apart) BOOST_TEST(!found.admits_step());
    }
  }
  BOOST_TEST(admitted > 10u);
  BOOST_TEST(refused > 10u);
}

BOOST_AUTO_TEST_SUITE_END()
