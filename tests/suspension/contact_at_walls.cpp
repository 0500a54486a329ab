// Tests contact with walls and held bodies (chapter 12): bodies that rest, slide or move through
// slots, and the loads that walls and supports carry.

#include <set>
#include <utility>

#include <boost/test/unit_test.hpp>

#include "contact_checks.hpp"
#include "contact_setup.hpp"
#include "double_layer/double_layer.hpp"
#include "support/exact_gaps.hpp"

namespace stokesbook::test {

using std::numbers::pi;

// Without contact, the step would end at a point deep within a held body, where the nearest way out
// is not unique.
BOOST_AUTO_TEST_CASE(a_step_that_would_end_deep_within_a_body) {
  for (const double angle : {0.0, 0.4, pi / 2}) {
    Scene scene = loaded({pushed(Circle{0.3}, {0.1, 2.0}, {0.0, -100.0}),
                          held(Ellipse{1.5, 0.8}, {0.0, 0.0}, angle)},
                         0.05);
    const SuspensionSolver solver(scene);
    const double speed = -solver.solve(solver.start()).motions[0].velocity.imag();
    const double dt = 2.0 / speed;
    scene = over(scene, dt, dt);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
    const double gap = least_gap(scene, run);
    BOOST_TEST(gap <= 0.05 * (1 + 4e-3));
    BOOST_TEST(run.frames.back().bodies[0].position.imag() > 0.0);
  }
}

namespace {

// A disk is pressed into the slit between two held disks. The prototype of the specification kept
// both gaps to a relative error of 1e-3.
void pinch_disk(int steps) {
  const double separation = 0.09, tolerance = 1e-5;
  const Complex force(0.0, -200.0);
  const Scene scene =
      over(solved_to(loaded({pushed(Circle{0.8}, {0.01, 1.6}, force),
                             held(Circle{1.0}, {-1.2, 0.0}), held(Circle{1.0}, {1.2, 0.0})},
                            separation),
                     tolerance),
           0.1 * steps, 0.1);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_REQUIRE(std::ssize(run.steps) == steps);
  for (const StepInfo& step : run.steps) BOOST_TEST(step.ncp_iterations <= 4);
  for (std::size_t k = 5; k < run.frames.size(); ++k) {
    const Frame& frame = run.frames[k];
    BOOST_REQUIRE(frame.contacts.size() == 2);
    const Complex position = frame.bodies[0].position;
    for (const std::size_t support : {1U, 2U}) {
      const double gap = std::abs(position - frame.bodies[support].position) - 1.8;
      BOOST_TEST(std::abs(gap - separation) <= 1e-5 * separation);
    }
    BOOST_TEST(std::abs(position - run.frames[5].bodies[0].position) <= 1e-5 * separation);
    // At rest, the contact forces balance the load. Only the errors of the solves remain.
    const Load pressed = contact_load(frame, {false, 0}, {});
    BOOST_TEST(std::abs(pressed.force + force) <= tolerance * std::abs(force));
  }
}

// Two flat sides leave a gap of one separation, or slightly more, on either side of a disk. The
// disk must move as it moves without contact, and must not drift sideways. The motions differ by
// the errors of both solutions, over a path of ten separations.
void move_along_a_slot(double width, double t_final, double end) {
  const double separation = 0.1, side = 0.5 + width * separation + 0.4;
  const Scene slot = loaded(
      {pushed(Circle{0.4}, {-0.5, 0.0}, {50.0, 0.0}), held(Superellipse{2.0, 0.5, 8}, {0.0, side}),
       held(Superellipse{2.0, 0.5, 8}, {0.0, -side})},
      separation);
  const Scene scene = over(solved_to(slot, 1e-4), t_final, 0.01);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  Scene free = scene;
  free.contact.reset();
  const RecordedRun freely = recorded_run(free);
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    const Complex position = run.frames[k].bodies[0].position;
    BOOST_TEST(std::abs(position.imag()) <= 1e-5 * separation);
    BOOST_TEST(std::abs(position - freely.frames[k].bodies[0].position) <= 1e-4 * separation);
  }
  BOOST_TEST(run.totals.rejected_steps == 0);
  BOOST_TEST(run.frames.back().bodies[0].position.real() > end);
}

// The ring between two walls leaves one separation on either side of a disk. By symmetry the disk
// moves on a circle: each step leaves the circle along the tangent, and contact leads the disk
// back. The relative difference from the free motion is the square of the angle of a step.
void move_round_in_a_ring(int steps) {
  const double separation = 0.1, radius = 0.4, inner = 1.0, middle = inner + separation + radius;
  const double dt = 0.02;
  Scene scene = in_container(middle + radius + separation,
                             {body_at(Circle{radius}, {middle, 0.0}, automatic_nodes)}, separation);
  scene.walls.push_back({.role = WallRole::inner, .shape = Circle{inner}});
  scene.walls[0].motion = RotatingWall{1.0};
  scene = over(scene, steps * dt, dt);
  const SuspensionSolver solver(scene);
  const RigidMotion free = solver.solve(solver.start()).motions[0];
  const double rate = free.velocity.imag() / middle;
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_TEST(run.totals.rejected_steps == 0);
  for (const Frame& frame : run.frames) {
    const Complex position = frame.bodies[0].position;
    BOOST_TEST(std::abs(std::abs(position) - middle) <= 1e-5 * separation);
    const double angle = std::arg(position * std::polar(1.0, -rate * frame.t));
    BOOST_TEST(std::abs(angle) <= std::pow(rate * dt, 2.0) * rate * frame.t);
  }
}

// A disk begins at the separation from a wall and is pressed onto the wall.
void rest_on_a_wall(int steps) {
  const double separation = 0.05, x = 2.0 - 0.5 - separation;
  const Scene scene =
      over(solved_to(in_container(2.0, {pushed(Circle{0.5}, {0.0, -x}, {0.0, -20.0})}, separation),
                     1e-4),
           0.1 * steps, 0.1);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_REQUIRE(std::ssize(run.steps) == steps);
  for (const Frame& frame : run.frames) {
    const Complex position = frame.bodies[0].position;
    BOOST_TEST(std::abs(std::abs(position) - x) <= 1e-5 * separation);
    BOOST_TEST(std::abs(position + Complex(0.0, x)) <= 1e-5 * separation);
    BOOST_TEST(largest_force(frame) == 20.0, boost::test_tools::tolerance(1e-5));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_pinched_disk_stays_where_it_is) {
  pinch_disk(40);
}

BOOST_AUTO_TEST_CASE(a_disk_moves_along_a_slot_that_fits) {
  move_along_a_slot(1.0, 0.2, -0.3);
}

BOOST_AUTO_TEST_CASE(a_disk_moves_round_in_a_ring_that_fits) {
  move_round_in_a_ring(40);
}

BOOST_AUTO_TEST_CASE(resting_contact_does_not_drift) {
  rest_on_a_wall(50);
}

BOOST_AUTO_TEST_CASE(contact_that_lasts_for_hundreds_of_steps_does_not_drift,
                     *boost::unit_test::label("full")) {
  pinch_disk(400);
  for (const double width : {1.0, 1.002}) move_along_a_slot(width, 1.0, 0.5);
  move_round_in_a_ring(200);
  rest_on_a_wall(400);
}

namespace {

// Returns the scene of a frame without contact: the contact forces are given as loads on the free
// bodies.
Scene loaded_by_hand(Scene scene, const Frame& frame) {
  scene.contact.reset();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    Body& body = scene.bodies[k];
    body.position = frame.bodies[k].position;
    body.orientation = frame.bodies[k].orientation;
    if (body.held) continue;
    const Load added = contact_load(frame, {false, k}, body.position);
    body.force += added.force;
    body.torque += added.torque;
  }
  return scene;
}

}  // namespace

// The contact force and torque (about a point) on the held ellipse are opposite to those on the
// free one, and its support carries them. The load of the held ellipse on the fluid is therefore
// the load that it would have if the contact force were a given load on the free body.
BOOST_AUTO_TEST_CASE(an_ellipse_slides_along_another_one) {
  const Body ellipse = pushed(Ellipse{0.5, 0.25}, {-1.5, 0.95}, {30.0, -60.0}, 0.6);
  const Scene scene = over(loaded({ellipse, held(Ellipse{3.0, 0.5}, {0.0, 0.0})}, 0.05), 6.0, 0.1);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_TEST(run.frames.back().bodies[0].position.real() > -1.0);
  int touching = 0;
  for (const Frame& frame : run.frames) {
    if (frame.contacts.size() != 1) continue;
    ++touching;
    const BodyState &free = frame.bodies[0], &support = frame.bodies[1];
    // The free body exerts its given load and the contact force on the fluid.
    const Complex force = free.force - ellipse.force;
    const double largest = frame.contacts[0].force;
    BOOST_TEST(std::abs(force) == largest, boost::test_tools::tolerance(1e-9));
    const Load reaction = contact_load(frame, {false, 1}, support.position);
    BOOST_TEST(std::abs(force + reaction.force) <= 1e-12 * largest);
    const double torque = free.torque + cross(free.position - support.position, force);
    BOOST_TEST(std::abs(torque + reaction.torque) <= 1e-12 * largest);
    const SuspensionSolver solver(loaded_by_hand(scene, frame));
    const Solution by_hand = solver.solve(solver.start());
    const double allowed = scene.solver.tolerance * std::abs(ellipse.force);
    BOOST_TEST(std::abs(by_hand.loads[1].force - support.force) <= allowed);
    BOOST_TEST(std::abs(by_hand.loads[1].torque - support.torque) <= allowed);
  }
  BOOST_TEST(touching > 20);
}

// A disk is pressed against a wall that moves towards it. The wall pushes the disk back, the disk
// rolls aside, and the contact ends.
BOOST_AUTO_TEST_CASE(a_moving_wall_pushes_a_disk) {
  Scene scene = in_contact(QuiescentFlow{}, {pushed(Circle{0.4}, {-0.6, 0.02}, {40.0, 0.0})}, 0.05);
  scene.solver.tolerance = 1e-3;
  scene.walls = {container(3.0), {.role = WallRole::inner, .shape = Circle{0.5}}};
  scene.walls[1].position = {0.5, 0.0};
  scene.walls[1].motion = TranslatingWall{{-0.5, 0.0}};
  scene = over(scene, 2.0, 0.05);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  for (std::size_t k = 4; k <= 24; ++k) {
    const Frame& frame = run.frames[k];
    BOOST_REQUIRE(frame.contacts.size() == 1);
    BOOST_TEST(frame.contacts[0].b.is_wall);
    BOOST_TEST(frame.contacts[0].b.number == 1);
    BOOST_TEST(frame.contacts[0].gap <= 0.05 * (1 + 4e-3));
    // The relative path is straight, and both of its ends are at the separation: |apart + dt
    // faster| = |apart|.
    const Complex apart = frame.bodies[0].position - frame.walls[1].position;
    const Complex faster = frame.bodies[0].velocity + 0.5;
    const double radial = (faster * std::conj(apart)).real();
    BOOST_TEST(std::abs(radial + 0.5 * 0.05 * std::norm(faster)) < 3e-3);
  }
  BOOST_TEST(run.frames.back().contacts.empty());
}

// A loaded ellipse sinks to the floor of a container and rests there.
BOOST_AUTO_TEST_CASE(bodies_rest_on_the_walls_of_a_container) {
  const Scene scene =
      over(solved_to(
               in_container(2.0, {pushed(Ellipse{0.6, 0.3}, {0.4, -1.0}, {0.0, -50.0}, 0.3)}, 0.05),
               1e-5),
           8.0, 0.1);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  const Frame& end = run.frames.back();
  BOOST_REQUIRE(!end.contacts.empty());
  double reaction = 0.0;
  for (const ContactForce& contact : end.contacts) {
    BOOST_TEST(contact.b.is_wall);
    reaction += contact.force * contact.normal.imag();
  }
  BOOST_TEST(std::abs(reaction - 50.0) <= 1e-5 * 50.0);
  BOOST_TEST(std::abs(end.bodies[0].velocity) < 0.01);
}

// A disk is pressed into the valley of a held star and rests on both flanks, on the axis of the
// valley. The cosine of the angle between a flank's normal and this axis is the derivative of the
// gap along the axis. A prototype of the specification found the forces 209 and 156.
BOOST_AUTO_TEST_CASE(a_disk_rests_on_both_flanks_of_a_valley) {
  const double separation = 0.09;
  const Complex force(30.0, -300.0);
  const PlacedShape star{Star{1.0, 0.45, 3}, {}, pi / 6};  // a valley above
  const Scene scene = over(loaded({pushed(Circle{0.45}, {0.0, 1.5}, force),
                                   held(star.shape, star.position, star.orientation)},
                                  separation),
                           4.0, 0.05);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  for (const StepInfo& step : run.steps) BOOST_TEST(step.ncp_iterations <= 6);
  // At rest, the forces of most instants are accurate to 1e-6, and those of some to a few 1e-6: the
  // residuals of the columns are at most 1e-5, the tolerance of GMRES.
  double sum_of_rests = 0.0, on_left = 0.0, on_right = 0.0;
  int count = 0;
  for (const Frame& frame : run.frames) {
    if (frame.t < 2.0) continue;
    BOOST_REQUIRE(frame.contacts.size() == 2);
    const double rest = std::abs(contact_load(frame, {false, 0}, {}).force + force);
    BOOST_TEST(rest <= 1e-5 * std::abs(force));
    sum_of_rests += rest;
    for (const ContactForce& contact : frame.contacts) {
      (contact.normal.real() < 0.0 ? on_right : on_left) += contact.force;
    }
    ++count;
  }
  BOOST_TEST(sum_of_rests <= 1e-6 * count * std::abs(force));
  const Frame& end = run.frames.back();
  BOOST_REQUIRE(end.contacts.size() == 2);
  const auto gap = [&](double y) { return exact_gap({Circle{0.45}, {0.0, y}}, star); };
  const double y = end.bodies[0].position.imag(), h = 1e-5;
  BOOST_TEST(std::abs(gap(y) - separation) <= 1e-5 * separation);
  const double cosine = (gap(y + h) - gap(y - h)) / (2.0 * h),
               sine = std::sqrt(1.0 - cosine * cosine);
  for (const double side : {-1.0, 1.0}) {
    const double mean = (side > 0.0 ? on_right : on_left) / count;
    const double known = 0.5 * (300.0 / cosine + side * 30.0 / sine);
    BOOST_TEST(mean == known, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(mean == (side > 0.0 ? 209.0 : 156.0), boost::test_tools::tolerance(4e-3));
  }
}

namespace {

// Returns the load on the supports of the walls (force and torque about the origin): the loads of
// the walls on the fluid minus the contact loads on the walls.
Load support_of_walls(const Frame& frame) {
  Load support;
  for (std::size_t k = 0; k < frame.walls.size(); ++k) {
    const WallLoad& wall = frame.walls[k];
    const Load by_contact = contact_load(frame, {true, k}, {});
    support.force += wall.force - by_contact.force;
    support.torque += wall.torque + cross(wall.position, wall.force) - by_contact.torque;
  }
  return support;
}

}  // namespace

// Bodies sink to the floor of a container, lie on each other, and slide off an inner wall. Through
// the fluid and by contact, the walls together carry all loads on the bodies.
BOOST_AUTO_TEST_CASE(walls_carry_what_rests_on_them) {
  const Complex weight(0.0, -20.0);
  Scene scene = in_container(
      2.0,
      {pushed(Circle{0.4}, {-0.5, -1.3}, weight), pushed(Circle{0.4}, {0.45, -1.3}, weight),
       pushed(Circle{0.4}, {0.0, -0.4}, weight),
       pushed(Ellipse{0.4, 0.2}, {0.2, 1.3}, weight, 0.2)},
      0.05);
  scene.walls.push_back({.role = WallRole::inner, .shape = Circle{0.3}, .position = {0.3, 0.6}});
  scene = over(scene, 4.0, 0.1);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  std::set<std::pair<ContactParty, ContactParty>> pairs;
  for (const Frame& frame : run.frames) {
    Load loads;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      loads.force += scene.bodies[k].force;
      loads.torque += cross(frame.bodies[k].position, scene.bodies[k].force);
    }
    const Load support = support_of_walls(frame);
    BOOST_TEST(std::abs(support.force + loads.force) <= 1e-12 * std::abs(weight));
    BOOST_TEST(std::abs(support.torque + loads.torque) <= 1e-12 * std::abs(weight));
    for (const ContactForce& contact : frame.contacts) pairs.emplace(contact.a, contact.b);
  }
  const ContactParty floor{true, 0}, within{true, 1};
  const ContactParty left{false, 0}, right{false, 1}, top{false, 2}, ellipse{false, 3};
  const std::set<std::pair<ContactParty, ContactParty>> expected{
      {left, top}, {right, top}, {left, floor}, {right, floor}, {ellipse, within}};
  BOOST_TEST((pairs == expected));
}

}  // namespace stokesbook::test
