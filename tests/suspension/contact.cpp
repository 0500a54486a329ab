// Contact in the suspension: pairs that are driven together stay apart, forces balance, runs end.

#include "suspension/contact.hpp"

#include <boost/test/unit_test.hpp>

#include "support/closed_forms.hpp"
#include "support/recorded_run.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

double distance(const Frame& frame, std::size_t a, std::size_t b) {
  return std::abs(frame.bodies[a].position - frame.bodies[b].position);
}

// Unit disks that a flow of rate 30 drives together: the free ends of a step overlap, or are past
// each other.
Scene head_on(double offset) {
  return in_contact(ExtensionalFlow{-30.0},
                    {body_at(Circle{1.0}, {-1.4, offset}, automatic_nodes),
                     body_at(Circle{1.0}, {1.4, -offset}, automatic_nodes)},
                    0.1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(disks_driven_through_each_other_stop_at_the_separation) {
  for (const double dt : {0.1, 0.3, 1.0}) {
    const RecordedRun run = recorded_run(over(head_on(0.0), dt, dt));
    const double gap = distance(run.frames.back(), 0, 1) - 2.0;
    BOOST_TEST(gap >= 0.1 * (1 - 1e-3));
    BOOST_TEST(gap <= 0.1 * (1 + 4e-3));
    BOOST_TEST(run.steps.front().ncp_iterations <= 2);
    BOOST_TEST(run.totals.rejected_steps == 0);
  }
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

// Columns are coarse, their sum is not: loads put on the bodies by hand move them alike.
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
  const Solution loaded = solver.solve(solver.initial_configuration());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    BOOST_TEST(std::abs(loaded.motions[k].velocity - frame.bodies[k].velocity) < 1e-5 * fastest);
    BOOST_TEST(std::abs(loaded.motions[k].omega - frame.bodies[k].omega) < 1e-5 * fastest);
  }
}

// Radius 1/2 on the axis of u = (-x, y), held at a gap of so many h = pi / 32: forces by a
// prototype of the specification, which tend to 3 pi with the gap.
BOOST_AUTO_TEST_CASE(the_force_that_holds_two_disks_apart) {
  const double h = std::numbers::pi / 32;
  const std::vector<std::pair<double, double>> known{{4.0, 10.1758}, {3.0, 9.9867}, {2.0, 9.7982},
                                                     {1.5, 9.7043},  {1.0, 9.6108}, {0.5, 9.5176},
                                                     {0.25, 9.4711}};
  for (const auto& [gap, force] : known) {
    const double x = 0.5 + 0.5 * gap * h;
    Scene scene = in_contact(ExtensionalFlow{-1.0},
                             {body_at(Circle{0.5}, {-x, 0.0}, automatic_nodes),
                              body_at(Circle{0.5}, {x, 0.0}, automatic_nodes)},
                             gap * h);
    const RecordedRun run = recorded_run(over(scene, 0.4, 0.1));
    BOOST_REQUIRE(run.frames.back().contacts.size() == 1);
    BOOST_TEST(run.frames.back().contacts[0].force == force, boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(starts_that_overlap_or_are_close_are_refused) {
  Scene scene = over(head_on(0.0), 0.1, 0.1);
  scene.bodies[0].position = {-0.9, 0.0};
  scene.bodies[1].position = {0.9, 0.0};
  const auto mentions = [](const std::string& text) {
    return [=](const ConfigurationRefused& refusal) {
      return std::string(refusal.what()).find(text) != std::string::npos;
    };
  };
  BOOST_CHECK_EXCEPTION(recorded_run(scene), ConfigurationRefused,
                        mentions("body 0 and body 1 by 0.2"));
  scene.bodies[0].position = {-1.03, 0.0};
  scene.bodies[1].position = {1.03, 0.0};
  BOOST_CHECK_EXCEPTION(recorded_run(scene), ConfigurationRefused, mentions("allow_close"));
  scene.contact->allow_close = true;
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST(distance(run.frames.back(), 0, 1) - 2.0 >= 0.06 - 2e-4);
}

// Two disks pass each other in shear and come back: without contact they would return to where they
// began.
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

// A disk is pushed into the slit between two held ones.
BOOST_AUTO_TEST_CASE(held_disks_carry_what_is_pressed_on_them) {
  Body pressed = body_at(Circle{0.8}, {0.0, 1.6}, automatic_nodes);
  pressed.force = {0.0, -200.0};
  std::vector<Body> bodies{pressed, body_at(Circle{1.0}, {-1.2, 0.0}, automatic_nodes),
                           body_at(Circle{1.0}, {1.2, 0.0}, automatic_nodes)};
  bodies[1].held = bodies[2].held = true;
  Scene scene = in_contact(QuiescentFlow{}, bodies, 0.09);
  scene.gauge_length = 100.0;
  const RecordedRun run = recorded_run(over(scene, 4.0, 0.1));
  const Frame& end = run.frames.back();
  BOOST_REQUIRE(end.contacts.size() == 2);
  Complex reaction{};
  for (const ContactForce& contact : end.contacts) {
    BOOST_TEST(contact.gap >= 0.09 * (1 - 1e-3));
    BOOST_TEST(contact.gap <= 0.09 * (1 + 4e-3));
    reaction += contact.force * (contact.a.number == 0 ? contact.normal : -contact.normal);
  }
  BOOST_TEST(std::abs(end.bodies[0].velocity) < 1e-3);
  BOOST_TEST(std::abs(reaction - Complex(0.0, 200.0)) < 0.5);
  for (const StepInfo& step : run.steps) BOOST_TEST(step.ncp_iterations <= 4);
}

// A loaded ellipse sinks to the floor of a container and rests there.
BOOST_AUTO_TEST_CASE(bodies_rest_on_the_walls_of_a_container) {
  Body heavy = body_at(Ellipse{0.6, 0.3}, {0.4, -1.0}, automatic_nodes);
  heavy.force = {0.0, -50.0};
  heavy.orientation = 0.3;
  Scene scene = in_contact(QuiescentFlow{}, {heavy}, 0.05);
  scene.walls = {{WallRole::outer, Circle{2.0}, {}, 0.0, automatic_nodes, {}}};
  const RecordedRun run = recorded_run(over(scene, 8.0, 0.1));
  const Frame& end = run.frames.back();
  BOOST_REQUIRE(!end.contacts.empty());
  double reaction = 0.0;
  for (const ContactForce& contact : end.contacts) {
    BOOST_TEST(contact.b.is_wall);
    BOOST_TEST(contact.gap >= 0.05 * (1 - 1e-3));
    reaction += contact.force * contact.normal.imag();
  }
  BOOST_TEST(reaction == 50.0, boost::test_tools::tolerance(0.01));
  BOOST_TEST(std::abs(end.bodies[0].velocity) < 0.01);
}

// A chases B: what an observer who moves along sees, is the same.
BOOST_AUTO_TEST_CASE(contact_is_the_same_for_every_observer) {
  const auto run = [](Complex boost) {
    Body chaser = body_at(Circle{1.0}, {-1.2, 0.1}, automatic_nodes);
    Body ahead = body_at(Ellipse{1.0, 0.6}, {1.1, 0.0}, automatic_nodes);
    chaser.force = 40.0;
    ahead.force = -40.0;
    Scene scene = in_contact(UniformFlow{boost}, {chaser, ahead}, 0.1);
    return recorded_run(over(scene, 0.5, 0.05));
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

// Order of Euler and of Heun with contact: a pair that is driven together, turns round, and parts.
BOOST_AUTO_TEST_CASE(steps_with_contact_keep_their_order) {
  const auto end = [](double dt, SteppingMethod method) {
    Scene scene = in_contact(ShearFlow{1.0},
                             {body_at(Circle{0.5}, {-1.5, 0.2}, automatic_nodes),
                              body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                             0.25);
    scene.output.dt_write = 6.0;
    scene.solver.tolerance = 1e-7;
    const Frame frame = recorded_run(over(scene, 6.0, dt, method)).frames.back();
    return frame.bodies[0].position - frame.bodies[1].position;
  };
  const Complex reference = end(0.0025, heun);
  const auto order = [&](SteppingMethod method) {
    return std::log2(std::abs(end(0.1, method) - reference) /
                     std::abs(end(0.025, method) - reference)) /
           2.0;
  };
  BOOST_TEST(order(euler) >= 0.8);
  BOOST_TEST(order(heun) >= 1.5);
}

BOOST_AUTO_TEST_CASE(a_hexagon_under_compression_is_resolved_at_any_step) {
  std::vector<Body> bodies{body_at(Circle{1.0}, {0.02, -0.01}, automatic_nodes)};
  for (int k = 0; k < 6; ++k) {
    const Complex corner = std::polar(2.15, std::numbers::pi / 3.0 * k + 0.1);
    bodies.push_back(body_at(Circle{1.0}, corner, automatic_nodes));
  }
  for (const double dt : {0.4, 0.1}) {
    Scene scene = over(in_contact(ExtensionalFlow{-1.0}, bodies, 0.1), 0.8, dt);
    scene.solver.tolerance = 1e-3;
    const RecordedRun run = recorded_run(scene);
    for (const StepInfo& step : run.steps) BOOST_TEST(step.ncp_iterations <= 9);
    for (std::size_t a = 0; a < 7; ++a) {
      for (std::size_t b = a + 1; b < 7; ++b) {
        BOOST_TEST(distance(run.frames.back(), a, b) - 2.0 >= 0.1 * (1 - 1e-3));
      }
    }
    BOOST_TEST(run.totals.largest_force_imbalance <= 1e-12);
    BOOST_TEST(run.totals.largest_torque_imbalance <= 1e-12);
  }
}

// A disk is pressed into the valley of a held star, and rests on both flanks.
BOOST_AUTO_TEST_CASE(a_disk_rests_on_both_flanks_of_a_valley) {
  Body disk = body_at(Circle{0.45}, {0.0, 1.5}, automatic_nodes);
  disk.force = {10.0, -300.0};
  Body star = body_at(Star{1.0, 0.45, 3}, {0.0, 0.0}, automatic_nodes);
  star.held = true;
  star.orientation = std::numbers::pi / 6;  // a valley above
  Scene scene = over(in_contact(QuiescentFlow{}, {disk, star}, 0.09), 4.0, 0.05);
  scene.gauge_length = 100.0;
  scene.solver.tolerance = 1e-3;
  const RecordedRun run = recorded_run(scene);
  const Frame& end = run.frames.back();
  BOOST_REQUIRE(end.contacts.size() == 2);
  Complex reaction{};
  for (const ContactForce& contact : end.contacts) reaction += contact.force * contact.normal;
  BOOST_TEST(std::abs(reaction - Complex(-10.0, 300.0)) < 3.0);
  for (const StepInfo& step : run.steps) BOOST_TEST(step.ncp_iterations <= 6);
}

// Two slender ellipses, flat on each other, are pressed together.
BOOST_AUTO_TEST_CASE(flat_contacts_do_not_rock) {
  std::vector<Body> bodies{body_at(Ellipse{1.0, 0.1}, {0.0, 0.3}, automatic_nodes),
                           body_at(Ellipse{1.0, 0.1}, {0.0, 0.0}, automatic_nodes)};
  bodies[0].force = {0.0, -10.0};
  bodies[1].force = {0.0, 10.0};
  Scene scene = over(in_contact(QuiescentFlow{}, bodies, 0.09), 4.0, 0.1);
  scene.solver.tolerance = 1e-3;
  const RecordedRun run = recorded_run(scene);
  const Frame& end = run.frames.back();
  BOOST_TEST(std::abs(end.bodies[0].orientation) < 0.01);
  BOOST_TEST(!end.contacts.empty());
  for (const ContactForce& contact : end.contacts) BOOST_TEST(contact.force < 20.0);
}

// The same scene ten times larger, and a thousand times smaller.
BOOST_AUTO_TEST_CASE(lengths_have_no_meaning) {
  const auto end = [](double unit) {
    Scene scene =
        in_contact(ShearFlow{1.0},
                   {body_at(Circle{0.5 * unit}, {-1.5 * unit, 0.2 * unit}, automatic_nodes),
                    body_at(Circle{0.5 * unit}, {0.0, 0.0}, automatic_nodes)},
                   0.25 * unit);
    return recorded_run(over(scene, 3.0, 0.1, heun)).frames.back().bodies[0].position / unit;
  };
  for (const double unit : {10.0, 1e-3}) BOOST_TEST(std::abs(end(unit) - end(1.0)) < 1e-5);
}

// A gap is kept for four hundred steps, without drift.
BOOST_AUTO_TEST_CASE(resting_contact_does_not_drift) {
  Body heavy = body_at(Circle{0.5}, {0.3, -1.3}, automatic_nodes);
  heavy.force = {0.0, -20.0};
  Scene scene = in_contact(QuiescentFlow{}, {heavy}, 0.05);
  scene.walls = {{WallRole::outer, Circle{2.0}, {}, 0.0, automatic_nodes, {}}};
  scene.solver.tolerance = 1e-4;
  scene.output.dt_write = 10.0;
  const RecordedRun run = recorded_run(over(scene, 40.0, 0.1));
  BOOST_REQUIRE(run.steps.size() == 400);
  for (std::size_t k = 200; k < run.steps.size(); ++k) {
    BOOST_TEST(run.steps[k].min_gap == run.steps[199].min_gap, boost::test_tools::tolerance(1e-3));
  }
}

// The first step takes both from a gap of 0.8 to one of 0.1, against the force; later ones hold it.
BOOST_AUTO_TEST_CASE(each_step_reports_what_contact_did) {
  const double dt = 0.1;
  const RecordedRun run = recorded_run(over(head_on(0.0), 3 * dt, dt));
  const double force = run.frames.front().contacts.at(0).force;
  BOOST_TEST(run.steps[0].contact_power == -force * 0.7 / dt, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(run.steps[0].energy_injected == 0.0);
  for (const StepInfo& step : run.steps) {
    BOOST_TEST(step.contacts == 1);
    BOOST_TEST(step.kkt_residual <= 1e-5);
    BOOST_TEST(step.force_imbalance <= 1e-12);
    BOOST_TEST(step.torque_imbalance <= 1e-12);
    if (step.t > 1.5 * dt) BOOST_TEST(std::abs(step.contact_power) < 1e-3 * force * 0.7 / dt);
  }
}

BOOST_AUTO_TEST_CASE(totals_count_what_contact_takes) {
  const RecordedRun run = recorded_run(over(head_on(0.0), 0.3, 0.1));
  long long iterations = 0, matvecs = 0;
  for (const StepInfo& step : run.steps) {
    iterations += step.gmres_iterations;
    matvecs += step.matvecs;
  }
  BOOST_TEST(run.totals.contact_solves > 0);
  BOOST_TEST(run.totals.gmres_iterations >= iterations);
  BOOST_TEST(run.totals.matvecs >= matvecs);
}

BOOST_AUTO_TEST_CASE(steps_without_contact_report_none) {
  const RecordedRun run =
      recorded_run(over(in_contact(ShearFlow{1.0},
                                   {body_at(Circle{0.5}, {-3.0, 0.5}, automatic_nodes),
                                    body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                                   0.05),
                        0.4, 0.2, heun));
  for (const StepInfo& step : run.steps) {
    BOOST_TEST(step.kkt_residual == 0.0);
    BOOST_TEST(step.contact_power == 0.0);
    BOOST_TEST(step.energy_injected == 0.0);
  }
}

// Disks driven at each other, a little off their line, slide past each other.
BOOST_AUTO_TEST_CASE(control_cuts_steps_that_forces_do_not_follow) {
  const auto end = [](const Scene& scene) { return recorded_run(scene).frames.back().bodies; };
  const auto reference = end(over(head_on(0.05), 0.1, 1e-4, heun));
  const auto error = [&](const Scene& scene) {
    return std::abs(end(scene)[0].position - reference[0].position);
  };
  Scene scene = over(head_on(0.05), 0.1, 0.1, heun);
  BOOST_TEST(error(scene) > 0.1);
  scene.time->tolerance = 1e-3;
  BOOST_TEST(error(scene) < 5e-3);
}

BOOST_AUTO_TEST_CASE(steps_with_contact_follow_the_effort) {
  Scene scene = over(head_on(0.0), 0.07, 0.01);
  scene.time->effort = EffortBounds{1000, 2000};
  const RecordedRun run = recorded_run(scene);
  BOOST_REQUIRE(run.steps.size() == 3);
  BOOST_TEST(run.steps[1].dt == 0.02, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(run.steps[2].dt == 0.04, boost::test_tools::tolerance(1e-9));
}

// A pair that is driven together, turns round, and parts: the error follows the tolerance.
BOOST_AUTO_TEST_CASE(errors_with_contact_follow_the_tolerance) {
  Scene scene = in_contact(ShearFlow{1.0},
                           {body_at(Circle{0.5}, {-1.5, 0.2}, automatic_nodes),
                            body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                           0.25);
  scene.output.dt_write = 6.0;
  scene.solver.tolerance = 1e-6;
  const auto distance = [](const RecordedRun& run) {
    return run.frames.back().bodies[0].position - run.frames.back().bodies[1].position;
  };
  const Complex reference = distance(recorded_run(over(scene, 6.0, 0.0025, heun)));
  long long steps = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    Scene controlled = over(scene, 6.0, 0.5, heun);
    controlled.time->tolerance = tolerance;
    const RecordedRun run = recorded_run(controlled);
    const double error = std::abs(distance(run) - reference) / 0.5;
    BOOST_TEST_MESSAGE("tolerance " << tolerance << " error " << error << " steps "
                                    << run.totals.steps << " rejected "
                                    << run.totals.rejected_steps);
    BOOST_TEST(error < 10.0 * tolerance);
    BOOST_TEST(run.totals.steps > steps);
    steps = run.totals.steps;
  }
  BOOST_TEST(steps < 1200);
}

namespace {

// Disks in shear meet, and slide past each other; by steps of a fixed length, or adapted ones.
Scene sliding_past(bool adapted) {
  Scene scene = over(in_contact(ShearFlow{1.0},
                                {body_at(Circle{0.5}, {-1.5, 0.2}, automatic_nodes),
                                 body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                                0.25),
                     4.0, 0.2, heun);
  if (adapted) scene.time->tolerance = 1e-2;
  return scene;
}

void resume_from_checkpoints(const Scene& scene) {
  const SuspensionSolver solver(scene);
  std::vector<Checkpoint> checkpoints;
  Observer observer;
  observer.checkpoint = [&](const Checkpoint& reached) { checkpoints.push_back(reached); };
  Frame whole, rest;
  observer.frame = [&](const Frame& frame) { whole = frame; };
  Simulation(solver, observer).run();
  Observer second;
  second.frame = [&](const Frame& frame) { rest = frame; };
  int in_contact = 0;
  for (const std::size_t quarter : {0U, 1U, 2U, 3U}) {
    const Checkpoint& checkpoint = checkpoints.at(quarter * checkpoints.size() / 4);
    in_contact += checkpoint.history.at("contact_loads").size() > 0 ? 1 : 0;
    Simulation resumed(solver, second);
    resumed.resume(checkpoint);
    resumed.run();
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(rest.bodies[k].position == whole.bodies[k].position);
      BOOST_TEST(rest.bodies[k].velocity == whole.bodies[k].velocity);
    }
  }
  BOOST_TEST(in_contact > 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(runs_with_contact_resume_bit_for_bit) {
  for (const bool adapted : {false, true}) resume_from_checkpoints(sliding_past(adapted));
}

// Without [time] there is no step: what holds at this instant.
BOOST_AUTO_TEST_CASE(one_solve_holds_apart_what_is_at_the_separation_and_closing) {
  const auto solved = [](double gap, double rate) {
    const double x = 1.0 + 0.5 * gap;
    const Scene scene = in_contact(ExtensionalFlow{rate},
                                   {body_at(Circle{1.0}, {-x, 0.0}, automatic_nodes),
                                    body_at(Circle{1.0}, {x, 0.0}, automatic_nodes)},
                                   0.1);
    Frame frame;
    Observer observer;
    observer.frame = [&](const Frame& only) { frame = only; };
    const SuspensionSolver solver(scene);
    Simulation(solver, observer).solve_once();
    return frame;
  };
  // Driven together, far and near; pulled apart.
  for (const double gap : {2.0, 0.2, 0.12}) {
    BOOST_TEST(solved(gap, -1.0).contacts.empty());
    BOOST_TEST(solved(gap, -1.0).bodies[0].velocity.real() > 0.0);
  }
  BOOST_TEST(solved(0.1, 1.0).contacts.empty());
  const Frame held = solved(0.1, -1.0);
  BOOST_REQUIRE(held.contacts.size() == 1);
  // At a gap of a tenth of the radius, mu = 1: by the table above, for radius 1/2.
  BOOST_TEST(held.contacts[0].force == 2.0 * 9.61, boost::test_tools::tolerance(0.01));
  BOOST_TEST(std::abs(held.bodies[0].velocity) <
             1e-2 * solved(0.12, -1.0).bodies[0].velocity.real());
}

}  // namespace stokesbook::test
