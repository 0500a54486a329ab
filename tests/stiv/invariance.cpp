// Checks that results do not depend on the observer, the scene's place and direction, its unit of
// length, the order of the components, and the number of threads.
#include <algorithm>
#include <cmath>
#include <set>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(invariance)

namespace {

constexpr double separation = 0.05;

ContactRules rules(RowChoice choice, double scale = 1.0) {
  return {{separation * scale}, 1e-4 * separation * scale, choice};
}

// Maps positions, shifts and sizes to another frame and unit.
struct View {
  double scale = 1.0, turn = 0.0;
  Complex shift{}, boost{};
};

Step seen(const Step& step, const View& view) {
  const Complex turn = std::polar(view.scale, view.turn);
  Step result = step;
  for (RigidPath& path : result.paths) {
    path.start = {view.shift + turn * path.start.position, path.start.orientation + view.turn};
    path.displacement = view.boost + turn * path.displacement;
  }
  if (view.scale == 1.0) return result;
  for (auto& shape : result.shapes) {
    const Polygon& polygon = shape->polygon;
    shape = std::make_shared<ContactShape>(ContactShape{
        Polygon(view.scale * polygon.vertices(), polygon.side()), view.scale * shape->weights,
        view.scale * shape->sag, view.scale * shape->radius});
  }
  return result;
}

double difference(const Wrench& p, const Wrench& q, const View& view) {
  const Complex turn = std::polar(1.0, view.turn);
  return std::abs(turn * p.force - q.force) + std::abs(p.torque - q.torque / view.scale);
}

double difference(const PairWrench& p, const PairWrench& q, const View& view) {
  return difference(p.on_a, q.on_a, view) + difference(p.on_b, q.on_b, view);
}

// Checks that another view has the same contacts, up to rounding.
void check_same(const std::vector<Contact>& contacts, const std::vector<Contact>& others,
                const View& view, double rounding) {
  BOOST_REQUIRE(contacts.size() == others.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact &contact = contacts[k], &other = others[k];
    BOOST_TEST(contact.a == other.a);
    BOOST_TEST(contact.b == other.b);
    BOOST_TEST(std::abs(contact.volume - other.volume / (view.scale * view.scale)) < rounding);
    BOOST_REQUIRE(contact.rows.size() == other.rows.size());
    for (std::size_t i = 0; i < contact.rows.size(); ++i) {
      const ContactRow &row = contact.rows[i], &copy = other.rows[i];
      BOOST_TEST((row.key == copy.key));
      BOOST_TEST(std::abs(row.gap - copy.gap / view.scale) < rounding);
      // Times are accurate only to the tolerance.
      BOOST_TEST(std::abs(row.time - copy.time) < 1e-6);
      BOOST_TEST(difference(row.derivative, copy.derivative, view) < 1e-6);
      BOOST_TEST(difference(row.force, copy.force, view) < 1e-6);
    }
  }
}

std::vector<Step> scenes() {
  std::vector<Step> steps;
  for (unsigned seed = 1; seed <= 6; ++seed) steps.push_back(random_step(12, seed, 0.6));
  return steps;
}

}  // namespace

BOOST_AUTO_TEST_CASE(rotation_translation_unit_and_observer) {
  for (const Step& step : scenes()) {
    for (RowChoice choice : {RowChoice::deepest, RowChoice::aggregate, RowChoice::every}) {
      const std::vector<Contact> contacts = interferences(step, rules(choice)).contacts;
      BOOST_TEST(!contacts.empty());
      for (const View& view : {View{.turn = 1.1}, View{.shift = {30.0, -20.0}}, View{.scale = 1e6},
                               View{.scale = 1e-6}, View{.boost = {10.0, -3.0}},
                               View{.turn = 2.0, .shift = {3.0, 1.0}, .boost = {-2.0, 9.0}}}) {
        check_same(contacts, interferences(seen(step, view), rules(choice, view.scale)).contacts,
                   view, 1e-12);
      }
    }
  }
}

// The rows are the same with a and b exchanged.
BOOST_AUTO_TEST_CASE(the_order_of_components) {
  for (const Step& step : scenes()) {
    Step reversed;
    const std::size_t n = step.shapes.size();
    for (std::size_t k = n; k-- > 0;) reversed.add(step.shapes[k], step.paths[k]);
    const auto rows_of = [](const Interferences& found) {
      std::vector<ContactRow> rows;
      for (const Contact& contact : found.contacts) {
        rows.insert(rows.end(), contact.rows.begin(), contact.rows.end());
      }
      return rows;
    };
    const std::vector<ContactRow> rows = rows_of(interferences(step, rules(RowChoice::deepest)));
    std::vector<ContactRow> mirrored = rows_of(interferences(reversed, rules(RowChoice::deepest)));
    for (ContactRow& row : mirrored) {
      row.key = {n - 1 - row.key.vertex_of, n - 1 - row.key.polygon_of, row.key.vertex};
    }
    BOOST_REQUIRE(rows.size() == mirrored.size());
    std::set<RowKey> keys;
    for (const ContactRow& row : rows) {
      const auto found = std::ranges::find(mirrored, row.key, &ContactRow::key);
      BOOST_REQUIRE((found != mirrored.end()));
      BOOST_TEST(keys.insert(row.key).second);
      BOOST_TEST(row.gap == found->gap);
      BOOST_TEST(row.time == found->time);
      BOOST_TEST(row.normal == -found->normal);
      BOOST_TEST(row.force.on_a.force == found->force.on_b.force);
      BOOST_TEST(row.force.on_a.torque == found->force.on_b.torque);
      BOOST_TEST(row.derivative.on_b.torque == found->derivative.on_a.torque);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const int threads_before = omp_get_max_threads();
  const Step step = random_step(40, 9, 0.8);
  const auto found_by = [&](int threads) {
    omp_set_num_threads(threads);
    return interferences(step, rules(RowChoice::every));
  };
  const Interferences alone = found_by(1);
  BOOST_TEST(alone.contacts.size() > 10u);
  for (int threads : {2, 3}) {
    const Interferences found = found_by(threads);
    BOOST_TEST((found.cost == alone.cost));
    BOOST_REQUIRE(found.contacts.size() == alone.contacts.size());
    for (std::size_t k = 0; k < found.contacts.size(); ++k) {
      const Contact &p = found.contacts[k], &q = alone.contacts[k];
      BOOST_TEST((p.a == q.a && p.b == q.b && p.volume == q.volume));
      BOOST_REQUIRE(p.rows.size() == q.rows.size());
      for (std::size_t i = 0; i < p.rows.size(); ++i) {
        BOOST_TEST((p.rows[i].key == q.rows[i].key));
        BOOST_TEST((p.rows[i].gap == q.rows[i].gap && p.rows[i].time == q.rows[i].time));
        BOOST_TEST((p.rows[i].point == q.rows[i].point));
      }
    }
  }
  omp_set_num_threads(threads_before);
}

BOOST_AUTO_TEST_SUITE_END()
