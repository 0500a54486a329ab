// Tests contact in the suspension (chapter 12): bodies that a flow or loads drive together stay
// apart, contact forces balance, and runs reach their end.

#include <boost/test/unit_test.hpp>

#include "contact_checks.hpp"
#include "contact_setup.hpp"
#include "support/exact_gaps.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

Scene with_control(Scene scene) {
  scene.time->tolerance = 1e-3;
  return scene;
}

double distance(const Frame& frame, std::size_t a, std::size_t b) {
  return std::abs(frame.bodies[a].position - frame.bodies[b].position);
}

}  // namespace

BOOST_AUTO_TEST_CASE(disks_driven_through_each_other_stop_at_the_separation) {
  for (const double dt : {0.1, 0.3, 1.0}) {
    const Scene scene = over(head_on(0.0), dt, dt);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
    const auto& ends = run.frames.back().bodies;
    BOOST_TEST(std::abs(ends[0].position + 1.05) <= 1e-12);
    BOOST_TEST(std::abs(ends[1].position - 1.05) <= 1e-12);
    BOOST_TEST(run.steps.front().ncp_iterations <= 2);
    BOOST_TEST(run.totals.rejected_steps == 0);
  }
}

// The disks are driven along slightly offset lines. Without contact they would pass at a gap of 0.8
// separations; with contact they slide round each other and separate. Only short steps resolve this
// motion, so the step control rejects long ones.
BOOST_AUTO_TEST_CASE(disks_that_nearly_miss_each_other_slide_past) {
  Scene free = over(head_on(0.05), 0.1, 5e-4, heun);
  free.contact.reset();
  BOOST_TEST(least_exact_gap(free, recorded_run(free).frames, 1.0) < 0.09);
  const Scene scene = with_control(over(head_on(0.05), 0.1, 0.1, heun));
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_TEST(run.totals.rejected_steps > 0);
  BOOST_TEST(
      std::ranges::any_of(run.steps, [](const StepInfo& step) { return step.contacts == 1; }));
  BOOST_TEST(run.frames.back().contacts.empty());
  BOOST_TEST(distance(run.frames.back(), 0, 1) - 2.0 > 1.5 * 0.1);
}

// At twice the offset the disks pass at a gap of more than one separation, so contact must not act.
// A long step would lead to a contact, so the step control shortens it.
BOOST_AUTO_TEST_CASE(disks_that_miss_each_other_are_not_in_contact) {
  const Scene scene = with_control(over(head_on(0.1), 0.1, 0.1, heun));
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_TEST(run.totals.rejected_steps > 0);
  for (const Frame& frame : run.frames) BOOST_TEST(frame.contacts.empty());
  for (const StepInfo& step : run.steps) BOOST_TEST(step.contacts == 0);
  Scene free = over(head_on(0.1), 0.1, 5e-4, heun);
  free.contact.reset();
  const Complex passed = recorded_run(free).frames.back().bodies[0].position;
  BOOST_TEST(std::abs(run.frames.back().bodies[0].position - passed) < 5e-4);
}

BOOST_AUTO_TEST_CASE(forces_of_contact_balance) {
  const RecordedRun run = recorded_run(over(head_on(0.0), 0.1, 0.1));
  const Frame& start = run.frames.front();
  BOOST_REQUIRE(start.contacts.size() == 1);
  BOOST_TEST(start.contacts[0].force > 0.0);
  BOOST_TEST(std::abs(start.bodies[0].force + start.bodies[1].force) <
             1e-12 * start.contacts[0].force);
  BOOST_TEST(std::abs(start.contacts[0].normal + Complex(1.0, 0.0)) < 1e-3);
}

BOOST_AUTO_TEST_CASE(stacks_of_three_keep_both_separations) {
  for (const SteppingMethod method : {euler, heun}) {
    const Scene scene = over(in_contact(ExtensionalFlow{-1.0},
                                        {body_at(Circle{1.0}, {-2.3, 0.0}, automatic_nodes),
                                         body_at(Circle{1.0}, {0.0, 0.0}, automatic_nodes),
                                         body_at(Circle{1.0}, {2.3, 0.0}, automatic_nodes)},
                                        0.1),
                             1.0, 0.1, method);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
    for (const std::size_t k : {0U, 1U}) {
      const double gap = distance(run.frames.back(), k, k + 1) - 2.0;
      BOOST_TEST(gap >= 0.1 * (1 - 1e-3));
      BOOST_TEST(gap <= 0.1 * (1 + 4e-3));
    }
    for (const StepInfo& step : run.steps) {
      BOOST_TEST(step.ncp_iterations <= (method == heun ? 6 : 3));
    }
  }
}

// The columns of the contact mobility are coarse, but the motion under the sum of all contact
// forces is accurate: given as loads, these forces move the bodies in the same way.
BOOST_AUTO_TEST_CASE(bodies_move_as_under_the_forces_of_contact) {
  std::vector<Body> bodies{body_at(Circle{1.0}, {0.02, -0.01}, automatic_nodes)};
  for (int k = 0; k < 6; ++k) {
    const Complex corner = std::polar(2.12, std::numbers::pi / 3.0 * k + 0.1);
    bodies.push_back(body_at(Ellipse{1.0, 0.95}, corner, automatic_nodes));
  }
  Scene scene = over(in_contact(ExtensionalFlow{-1.0}, bodies, 0.1), 0.4, 0.4);
  const Frame frame = recorded_run(scene).frames.front();
  BOOST_TEST(frame.contacts.size() >= 3);
  double fastest = 0.0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    scene.bodies[k].force = frame.bodies[k].force;
    scene.bodies[k].torque = frame.bodies[k].torque;
    fastest = std::max(fastest, std::abs(frame.bodies[k].velocity));
  }
  const SuspensionSolver solver(scene);
  const Solution loaded = solver.solve(solver.start());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    BOOST_TEST(std::abs(loaded.motions[k].velocity - frame.bodies[k].velocity) < 1e-5 * fastest);
    BOOST_TEST(std::abs(loaded.motions[k].omega - frame.bodies[k].omega) < 1e-5 * fastest);
  }
}

// Disks of radius 1/2 on the axis of u = (-x, y) are held at gaps that are multiples of h = pi /
// 32. A prototype of the specification computed the forces, which tend to 3 pi as the gap tends to
// zero.
BOOST_AUTO_TEST_CASE(the_force_that_holds_two_disks_apart) {
  const double h = std::numbers::pi / 32;
  const std::vector<std::pair<double, double>> known{{4.0, 10.1758}, {3.0, 9.9867}, {2.0, 9.7982},
                                                     {1.5, 9.7043},  {1.0, 9.6108}, {0.5, 9.5176},
                                                     {0.25, 9.4711}};
  for (const auto& [gap, force] : known) {
    const double x = 0.5 + 0.5 * gap * h;
    const Scene scene = over(in_contact(ExtensionalFlow{-1.0},
                                        {body_at(Circle{0.5}, {-x, 0.0}, automatic_nodes),
                                         body_at(Circle{0.5}, {x, 0.0}, automatic_nodes)},
                                        gap * h),
                             0.4, 0.1);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
    BOOST_REQUIRE(run.frames.back().contacts.size() == 1);
    BOOST_TEST(run.frames.back().contacts[0].force == force, boost::test_tools::tolerance(1e-3));
  }
}

// Two disks pass each other in shear, and the flow is reversed. Without contact they would return
// to their start.
BOOST_AUTO_TEST_CASE(reversed_shear_leaves_what_contact_has_moved) {
  const double h = std::numbers::pi / 32;
  const auto returned = [&](double gaps, double dt) {
    Scene scene = in_contact(ShearFlow{1.0},
                             {body_at(Circle{0.5}, {-8.0, 0.5}, automatic_nodes),
                              body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                             gaps * h);
    scene.reverse_at = {20.0};
    scene.output.dt_write = 40.0;
    const RecordedRun run = recorded_run(over(scene, 40.0, dt));
    const auto& start = run.frames.front().bodies;
    const auto& end = run.frames.back().bodies;
    double change = 0.0, size = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      change += std::norm(end[k].position - start[k].position);
      size += std::norm(start[k].position);
    }
    return std::sqrt(change / size);
  };
  BOOST_TEST(returned(1.0, 0.08) == 0.135, boost::test_tools::tolerance(0.06));
  BOOST_TEST(returned(2.0, 0.08) == 0.188, boost::test_tools::tolerance(0.06));
  BOOST_TEST(returned(3.0, 0.08) == 0.412, boost::test_tools::tolerance(0.06));
}

// Body A chases body B: the relative motion and the force are the same for an observer who moves
// uniformly.
BOOST_AUTO_TEST_CASE(contact_is_the_same_for_every_observer) {
  const auto run = [](Complex boost) {
    Body chaser = body_at(Circle{1.0}, {-1.2, 0.1}, automatic_nodes);
    Body ahead = body_at(Ellipse{1.0, 0.6}, {1.1, 0.0}, automatic_nodes);
    chaser.force = 40.0;
    ahead.force = -40.0;
    const Scene scene = over(in_contact(UniformFlow{boost}, {chaser, ahead}, 0.1), 0.5, 0.05);
    const RecordedRun recorded = recorded_run(scene);
    check_contact(scene, recorded);
    return recorded;
  };
  const Complex boost(7.0, -3.0);
  const Frame still = run({}).frames.back(), moving = run(boost).frames.back();
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(std::abs(moving.bodies[k].position - 0.5 * boost - still.bodies[k].position) < 1e-6);
  }
  BOOST_REQUIRE(still.contacts.size() == 1);
  BOOST_TEST(moving.contacts.at(0).force == still.contacts[0].force,
             boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(a_hexagon_under_compression_is_resolved_at_any_step) {
  std::vector<Body> bodies{body_at(Circle{1.0}, {0.02, -0.01}, automatic_nodes)};
  for (int k = 0; k < 6; ++k) {
    const Complex corner = std::polar(2.15, std::numbers::pi / 3.0 * k + 0.1);
    bodies.push_back(body_at(Circle{1.0}, corner, automatic_nodes));
  }
  for (const double dt : {0.4, 0.2, 0.1, 0.05}) {
    const Scene scene =
        over(solved_to(in_contact(ExtensionalFlow{-1.0}, bodies, 0.1), 1e-3), 0.8, dt);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
  }
}

// The tip of a star is pressed, slightly off the axis, into the valley of another star. The motion
// begins where the gap is one separation.
BOOST_AUTO_TEST_CASE(stars_are_pressed_tip_in_valley) {
  const double separation = 0.05;
  const Star star{1.0, 0.2, 5};
  Complex away(1.8, 0.02);
  while (exact_gap({star}, {star, away}) < separation) away += 1e-3;
  const Scene scene =
      over(loaded({pushed(star, {}, {30.0, 0.0}), pushed(star, away, {-30.0, 0.0})}, separation),
           0.6, 0.1);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  for (const Frame& frame : run.frames) BOOST_TEST(!frame.contacts.empty());
  BOOST_TEST(run.frames.back().contacts.size() == 2);
}

// Two slender ellipses are pressed together along their flat sides: once with few graded nodes,
// once with many nodes that are not graded.
BOOST_AUTO_TEST_CASE(flat_contacts_do_not_rock) {
  for (const int nodes : {automatic_nodes, 256}) {
    std::vector<Body> bodies{pushed(Ellipse{1.0, 0.1}, {0.0, 0.3}, {0.0, -10.0}),
                             pushed(Ellipse{1.0, 0.1}, {0.0, 0.0}, {0.0, 10.0})};
    for (Body& body : bodies) body.n_nodes = nodes;
    const Scene scene = over(solved_to(in_contact(QuiescentFlow{}, bodies, 0.09), 3e-4), 4.0, 0.1);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
    BOOST_TEST(run.resolution.most_nodes[0] <= (nodes == automatic_nodes ? 96 : nodes));
    for (const Frame& frame : run.frames) {
      for (const BodyState& body : frame.bodies) BOOST_TEST(std::abs(body.orientation) < 1e-5);
    }
    // Each force corrects the errors that the steps before have left in the gap. Most of these
    // errors change from step to step. The mean force is the load, as far as the tolerance of the
    // solves allows.
    std::vector<Complex> forces;
    for (const Frame& frame : run.frames) {
      if (frame.contacts.empty()) continue;
      forces.push_back(contact_load(frame, {false, 0}, {}).force);
    }
    BOOST_TEST_REQUIRE(forces.size() > 10);
    BOOST_TEST(!run.frames.back().contacts.empty());
    forces.erase(forces.begin());  // contact began in the middle of this step
    Complex sum{};
    for (const Complex force : forces) {
      BOOST_TEST(std::abs(force - Complex(0.0, 10.0)) < 5e-3 * 10.0);
      sum += force;
    }
    BOOST_TEST(std::abs(sum / static_cast<double>(forces.size()) - Complex(0.0, 10.0)) <
               1e-3 * 10.0);
  }
}

// A separation in units of the node spacing refers to the mean spacing of all bodies.
BOOST_AUTO_TEST_CASE(separations_in_spacings_are_those_of_all_bodies) {
  Scene scene = in_contact(QuiescentFlow{},
                           {body_at(Circle{1.0}, 0.0, 64), body_at(Circle{0.5}, 5.0, 32)}, 0.2);
  BOOST_TEST(SuspensionSolver(scene).separation() == 0.2);
  scene.contact->in_spacings = true;
  const double spacing = 2.0 * std::numbers::pi * 1.5 / 96.0;
  BOOST_TEST(SuspensionSolver(scene).separation() == 0.2 * spacing,
             boost::test_tools::tolerance(1e-12));
}

// The same scene is ten times larger, or a thousand times smaller.
BOOST_AUTO_TEST_CASE(lengths_have_no_meaning) {
  const auto end = [](double unit) {
    const Scene scene =
        over(in_contact(ShearFlow{1.0},
                        {body_at(Circle{0.5 * unit}, {-1.5 * unit, 0.2 * unit}, automatic_nodes),
                         body_at(Circle{0.5 * unit}, {0.0, 0.0}, automatic_nodes)},
                        0.25 * unit),
             3.0, 0.1, heun);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run);
    return run.frames.back().bodies[0].position / unit;
  };
  for (const double unit : {10.0, 1e-3}) BOOST_TEST(std::abs(end(unit) - end(1.0)) < 1e-5);
}

}  // namespace stokesbook::test
