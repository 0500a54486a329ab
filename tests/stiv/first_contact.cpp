// Checks first contact times against closed forms: approaches head-on and oblique, at any speed,
// turning bodies, containers, and walls that move. Also checks steps without contact.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "steps.hpp"
#include "trapezoid/shape.hpp"

using namespace stokesbook;
using namespace stokesbook::test;
using Eigen::Index;

BOOST_AUTO_TEST_SUITE(first_contact)

namespace {

constexpr double delta = 0.1, tolerance = 1e-4 * delta;

// With an allowed intrusion of 0, every contact counts as deep, so that its first instant is
// reported.
ContactRules rules(double tol = tolerance) {
  return {
      .separation = {delta}, .tolerance = tol, .rows = RowChoice::every, .allowed_intrusion = 0.0};
}

const ContactRules default_rules{{delta}, tolerance, RowChoice::every};

// Two unit circles approach from both sides, one of them shifted aside.
Step approach(double aside, double travel, Index m) {
  Step step;
  step.add(body(Circle{1.0}, m), {{{-3.0, 0.0}, 0.1}, {travel, 0.0}, 0.3});
  step.add(body(Circle{1.0}, m), {{{3.0, aside}, 0.1}, {-travel, 0.0}, -0.2});
  return step;
}

// Returns the orientation at which an ellipse comes within a distance of a point, by bisection.
double touching_orientation(const Ellipse& ellipse, Complex point, double distance, double low,
                            double high) {
  const Parametrisation curve = parametrisation(Shape{ellipse});
  const auto distance_at = [&](double theta) {
    const Complex local = std::polar(1.0, -theta) * point;
    double least = INFINITY;
    double best = 0.0;
    for (double width = std::numbers::pi; width > 1e-9; width *= 0.02) {
      const double centre = best;
      for (int i = -100; i <= 100; ++i) {
        const double t = centre + 0.01 * i * width;
        const double d = std::abs(curve(t).value - local);
        if (d < least) least = d, best = t;
      }
    }
    return least;
  };
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (distance_at(middle) > distance ? low : high) = middle;
  }
  return low;
}

}  // namespace

BOOST_AUTO_TEST_CASE(circles_head_on_and_oblique) {
  for (double aside : {0.0, 0.3, 1.0, 1.9}) {
    for (double travel : {2.6, 3.0, 10.0, 1000.0}) {
      for (Index m : {32, 128, 1024}) {
        const Step step = approach(aside, travel, m);
        const std::vector<Contact> contacts = violated(interferences(step, rules()));
        BOOST_REQUIRE(contacts.size() == 1u);
        const double apart = std::sqrt((2.0 + delta) * (2.0 + delta) - aside * aside);
        const double exact = (6.0 - apart) / (2.0 * travel);
        // Polygons lie within their circles, and therefore meet later.
        const double normal_speed = 2.0 * travel * apart / (2.0 + delta);
        const double late = (first_time(contacts) - exact) * normal_speed;
        BOOST_TEST(late > -1.01 * tolerance);
        BOOST_TEST(late < 1.05 * 2.0 * step.shapes[0]->sag + 1e-12);
      }
    }
  }
}

// The tolerance limits how early a contact is found; a contact is never found late.
BOOST_AUTO_TEST_CASE(the_tolerance_bounds_the_time) {
  const double sharp = first_time(violated(interferences(approach(1.0, 3.0, 64), rules(1e-12))));
  for (double tol : {1e-2, 1e-4, 1e-6}) {
    const double found =
        first_time(violated(interferences(approach(1.0, 3.0, 64), rules(tol * delta))));
    BOOST_TEST(found <= sharp);
    BOOST_TEST(found > sharp - tol * delta / (6.0 * 0.8));
  }
}

// The circles have passed through each other, so that a static check of the end finds no contact.
BOOST_AUTO_TEST_CASE(tunnelling_is_found_for_every_step) {
  const auto circle = body(Circle{1.0}, 96);
  for (double dt : {0.02, 0.1, 0.3, 1.0, 1000.0}) {
    Step step;
    step.add(circle, {{{-1.4, 0.0}, 0.0}, {42.0 * dt, 0.0}, 0.0});
    step.add(circle, {{{1.4, 0.0}, 0.0}, {-42.0 * dt, 0.0}, 0.0});
    const std::vector<Contact> contacts = violated(interferences(step, rules()));
    BOOST_REQUIRE(contacts.size() == 1u);
    BOOST_TEST(std::abs(first_time(contacts) - 0.7 / (84.0 * dt)) < tolerance / (84.0 * dt));
    // The vertices face each other: the gap (10.5) counts the whole excess of the displacement.
    BOOST_TEST(std::abs(least_gap(contacts) + 84.0 * dt - 0.7) < 1e-12 * (1.0 + 84.0 * dt));
  }
}

// Checks how near circles come as they pass each other: an intrusion into the separation is
// admitted, up to the permitted part of the separation.
BOOST_AUTO_TEST_CASE(passing_by_is_no_contact) {
  const double sags = 2.0 * sag(sample(Circle{1.0}, 1024, Side::fluid_outside));
  for (double travel : {3.0 + 1.5, 6.0, 100.0}) {
    for (double intrusion : {0.0, 0.5, 1.0}) {
      ContactRules with_intrusion = default_rules;
      if (intrusion != 0.5) with_intrusion.allowed_intrusion = intrusion;  // otherwise the default
      const auto is_admitted = [&](double nearest) {
        return interferences(approach(2.0 + nearest, travel, 1024), with_intrusion).admits_step() &&
               interferences(approach(-2.0 - nearest, travel, 1024), with_intrusion).admits_step();
      };
      const double allowed = (1.0 - intrusion) * delta;
      BOOST_TEST(is_admitted(allowed + 2.0 * tolerance));
      // Steps in contact are half the separation, and may miss an intrusion that is only slightly
      // deeper.
      BOOST_TEST(!is_admitted(intrusion == 0.0 ? allowed - sags - 1e-3 : -1e-2));
    }
  }
}

// An ellipse passes through a circle in half a turn and returns to its initial shape.
BOOST_AUTO_TEST_CASE(a_turning_ellipse_sweeps_a_circle) {
  const Ellipse ellipse{1.0, 0.1};
  const Complex centre{0.3, 0.9};
  const double radius = 0.25;
  const double touching =
      touching_orientation(ellipse, centre, radius + delta, 0.0, std::arg(centre));
  Step step;
  step.add(body(ellipse, 1024), {{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
  step.add(body(Circle{radius}, 1024), {{centre, 0.0}, {0.0, 0.0}, 0.0});
  BOOST_TEST(interferences(step, rules()).admits_step());
  for (double turn : {1.05 * touching, 2.0, std::numbers::pi}) {
    step.paths[0].rotation = turn;
    const std::vector<Contact> contacts = violated(interferences(step, rules()));
    BOOST_REQUIRE(!contacts.empty());
    // The touching point moves at most as fast as the tip.
    BOOST_TEST(first_time(contacts) * turn > touching - 4.0 * tolerance);
    BOOST_TEST(first_time(contacts) * turn < touching + 1e-4);
  }
  // Any number of turns violates the separation.
  for (double turn : {2.0 * std::numbers::pi, -60.0}) {
    step.paths[0].rotation = turn;
    BOOST_TEST(!interferences(step, rules()).admits_step());
  }
  // The circle may turn by any angle without contact.
  Step turned = step;
  turned.paths[0].rotation = 0.0;
  turned.paths[1].rotation = -std::numbers::pi;
  BOOST_TEST(interferences(turned, rules()).admits_step());
  step.paths[0].rotation = 0.95 * touching;
  BOOST_TEST(interferences(step, rules()).admits_step());
  step.paths[0].rotation = -0.5 * touching;
  BOOST_TEST(interferences(step, rules()).admits_step());
}

BOOST_AUTO_TEST_CASE(containers_and_walls_that_move) {
  const Index m = 512;
  const auto wall = container(Circle{3.0}, m), disk = body(Circle{0.5}, m);
  const double way = 3.0 - 0.5 - delta - 0.4;
  for (double wall_part : {0.0, 0.3, 1.0}) {
    for (double travel : {1.0, 1.99, 2.01, 5.0, 300.0}) {
      Step step;
      step.add(disk, {{{0.4, 0.0}, 0.2}, {(1.0 - wall_part) * travel, 0.0}, 0.1});
      step.add(wall, {{{0.0, 0.0}, 0.5}, {-wall_part * travel, 0.0}, 0.0});
      const std::vector<Contact> contacts = violated(interferences(step, rules()));
      BOOST_TEST(contacts.size() == (travel > way ? 1u : 0u));
      if (contacts.empty()) continue;
      const double late = first_time(contacts) * travel - way;
      BOOST_TEST(late > -1.05 * wall->sag - tolerance);
      BOOST_TEST(late < 1.05 * disk->sag);
      // Outside the wall the disk meets no other part of the wall, so that all forces point
      // inwards.
      for (const ContactRow& row : contacts[0].rows) BOOST_TEST(row.normal.real() < 0.0);
      BOOST_TEST(std::abs(least_gap(contacts) - (way - travel)) < 1e-3 * travel);
    }
  }
}

// An inner wall is a held body and may turn: the turning wall approaches a body at rest.
BOOST_AUTO_TEST_CASE(a_turning_inner_wall) {
  Step step;
  step.add(body(Circle{0.5}, 256), {{{1.8, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
  step.add(body(Ellipse{1.5, 0.5}, 1024), {{{0.0, 0.0}, 0.5 * std::numbers::pi}, {0.0, 0.0}, 0.0});
  BOOST_TEST(interferences(step, rules()).admits_step());
  step.paths[1].rotation = -std::numbers::pi;
  const double touching =
      touching_orientation({1.5, 0.5}, Complex{0.0, 1.8}, 0.5 + delta, 0.0, 0.5 * std::numbers::pi);
  const std::vector<Contact> contacts = violated(interferences(step, rules()));
  BOOST_REQUIRE(!contacts.empty());
  BOOST_TEST(std::abs(first_time(contacts) * std::numbers::pi - touching) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_start_at_the_separation) {
  const auto circle = body(Circle{1.0}, 128);
  for (double slack : {0.0, 0.5 * tolerance, -0.5 * tolerance}) {
    const auto after = [&](Complex displacement) {
      Step step;
      step.add(circle, {{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
      step.add(circle, {{{2.0 + delta + slack, 0.0}, 0.0}, displacement, 0.0});
      return interferences(step, rules());
    };
    const std::vector<Contact> contacts = violated(after({-0.01, 0.0}));
    BOOST_REQUIRE(contacts.size() == 1u);
    BOOST_TEST(first_time(contacts) == 0.0);
    BOOST_TEST(std::abs(least_gap(contacts) - (slack - 0.01)) < 1e-14);
    // At rest, sliding or leaving, the circles have no contact, for any displacement.
    for (Complex displacement : {Complex{0.0, 0.0}, {0.0, 0.3}, {0.01, -0.2}, {5.0, 0.0}}) {
      const Interferences found = after(displacement);
      BOOST_TEST(found.admits_step());
      // Pairs that stay near are listed.
      BOOST_TEST(found.contacts.empty() == (std::abs(displacement) > 1.0));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_apart_costs_nothing) {
  Step step;
  step.add(body(Circle{1.0}, 64), {{{0.0, 0.0}, 0.0}, {1.0, 1.0}, 0.1});
  step.add(body(Circle{1.0}, 64), {{{9.0, 0.0}, 0.0}, {1.0, -1.0}, 0.1});
  const Interferences found = interferences(step, rules());
  BOOST_TEST(found.contacts.empty());
  BOOST_TEST((found.cost == SearchCost{}));
}

// A disk is pressed into the valley of a star and meets both flanks at once.
BOOST_AUTO_TEST_CASE(a_disk_in_a_valley_has_two_contacts) {
  const auto star = body(Star{1.0, 0.45, 3}, 768), disk = body(Circle{0.45}, 256);
  const Complex valley = std::polar(1.0, std::numbers::pi / 3.0);
  // Finds the centre at which the disk's surface is delta from the star's, which is 0.45 + delta
  // from the centre.
  double low = 1.0, high = 2.0;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    const double distance = star->polygon.closest(middle * valley, INFINITY).distance;
    (distance > 0.45 + delta ? high : low) = middle;
  }
  for (double travel : {0.52, 0.6, 3.0}) {
    Step step;
    step.add(star, {{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0});
    step.add(disk, {{(low + 0.5) * valley, std::numbers::pi / 3.0}, -travel * valley, 0.0});
    const std::vector<Contact> contacts = violated(interferences(step, rules()));
    BOOST_TEST(std::abs(first_time(contacts) * travel - 0.5) < 2e-3);
    if (travel > 1.0) continue;  // right through: both flanks are a single contact
    BOOST_REQUIRE(contacts.size() == 2u);
    // The two contacts are mirror images about the axis of the valley.
    const auto mean_normal = [&](const Contact& contact) {
      Complex sum{};
      for (const ContactRow& row : contact.rows) sum += row.normal;
      return std::conj(valley) * sum / std::abs(sum);
    };
    const Complex first = mean_normal(contacts[0]), second = mean_normal(contacts[1]);
    BOOST_TEST(std::abs(first - std::conj(second)) < 1e-2);
    BOOST_TEST(std::abs(first.imag()) > 0.2);
    BOOST_TEST(std::abs(contacts[0].volume / contacts[1].volume - 1.0) < 1e-2);
  }
}

// A disk grazes a lobe and runs into the other lobe, which is the first contact.
BOOST_AUTO_TEST_CASE(a_contact_that_was_left_is_forgotten) {
  const double radius = 0.3;
  const auto lobes = body(Star{1.0, 0.45, 2}, 512), disk = body(Circle{radius}, 256);
  Eigen::Index top = 0;
  lobes->polygon.vertices().imag().maxCoeff(&top);
  const Complex summit = lobes->polygon.vertex(top);
  const double half = std::abs(summit.real()), height = summit.imag() + radius;
  BOOST_REQUIRE(half > 0.5);
  // The gap is 0.9 of the separation over the first summit, and -0.5 over the second.
  const double slope = -(0.9 * delta + 0.5 * delta) / (2.0 * half), run_up = 1.5;
  const double way = 2.0 * half + run_up;
  Step step;
  step.add(lobes, {});
  step.add(
      disk,
      {{{-half - run_up, height + 0.9 * delta - slope * run_up}, 0.0}, {way, slope * way}, 0.0});
  Step grazing = step;
  grazing.paths[1].displacement *= (half + run_up) / way;
  BOOST_TEST(!interferences(grazing, default_rules).contacts.empty());
  const std::vector<Contact> contacts = violated(interferences(step, default_rules));
  BOOST_TEST(!contacts.empty());
  BOOST_TEST(first_time(contacts) > (half + run_up) / way);
}

// A body that slides along a floor is in contact all the time. The search must find the thin wall
// that the body then meets, although the body has passed the wall at the end.
BOOST_AUTO_TEST_CASE(a_second_contact_within_the_first) {
  const ComplexVector corners = ComplexVector{{Complex{-3.0, -1.0},
                                               {3.0, -1.0},
                                               {3.0, 0.0},
                                               {1.1, 0.0},
                                               {1.1, 1.0},
                                               {1.0, 1.0},
                                               {1.0, 0.0},
                                               {-3.0, 0.0}}};
  const auto floor = std::make_shared<ContactShape>(ContactShape{
      Polygon(corners, Side::fluid_outside), Eigen::VectorXd::Ones(corners.size()), 0.0, 3.2});
  const double radius = 1e-6;
  Step step;
  step.add(floor, {});
  step.add(body(Circle{radius}, 16), {{{-1.0, delta + radius}, 0.0}, {1.8, 0.0}, 0.0});
  BOOST_TEST(interferences(step, default_rules).admits_step());
  step.paths[1].displacement = 3.0;
  const std::vector<Contact> contacts = violated(interferences(step, default_rules));
  BOOST_REQUIRE(contacts.size() == 1u);
  for (const ContactRow& row : contacts[0].rows) BOOST_TEST(row.normal.real() > 0.99);
  BOOST_TEST(least_gap(contacts) < -1.0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  Step step = approach(0.0, 3.0, 32);
  BOOST_CHECK_THROW(interferences(step, {{0.0}, tolerance}), std::invalid_argument);
  BOOST_CHECK_THROW(interferences(step, {{delta}, 0.0}), std::invalid_argument);
  const auto says = [](const std::string& message) {
    return [=](const std::invalid_argument& error) { return error.what() == message; };
  };
  BOOST_CHECK_EXCEPTION(
      interferences(step, {{delta, {{{0, 1}, -1e-8}}}, tolerance}), std::invalid_argument,
      says("contact requires a positive separation of components 0 and 1, got -1e-08"));
  BOOST_CHECK_EXCEPTION(
      interferences(step,
                    {.separation = {delta}, .tolerance = tolerance, .allowed_intrusion = 1.5}),
      std::invalid_argument, says("contact requires an allowed intrusion from 0 to 1, got 1.5"));
  step.paths[1].displacement = {std::nan(""), 0.0};
  BOOST_CHECK_THROW(interferences(step, rules()), std::invalid_argument);
  step.paths.pop_back();
  BOOST_CHECK_THROW(interferences(step, rules()), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
