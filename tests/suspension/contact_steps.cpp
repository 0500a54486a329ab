// Tests steps with contact (chapters 09 and 12): their order, step control and reports, and how
// interrupted runs resume.

#include <algorithm>

#include <boost/test/unit_test.hpp>

#include "contact_checks.hpp"
#include "contact_setup.hpp"
#include "suspension/motion/statistics.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

// Returns two disks that shear drives together, turns round each other, and separates.
Scene passing_pair() {
  return in_contact(ShearFlow{1.0},
                    {body_at(Circle{0.5}, {-1.5, 0.2}, automatic_nodes),
                     body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                    0.25);
}

// Returns the same pair while the disks slide past each other, with steps of a fixed length or
// adaptive steps.
Scene sliding_past(bool adapted) {
  Scene scene = over(passing_pair(), 4.0, 0.2, heun);
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

// Checks the measured orders of Euler's and Heun's methods with contact, between two step lengths.
void check_orders(double long_step, double short_step, double reference_step) {
  const auto end = [](double dt, SteppingMethod method) {
    Scene scene = passing_pair();
    scene.output.dt_write = 6.0;
    scene.solver.tolerance = 1e-7;
    const RecordedRun run = recorded_run(over(scene, 6.0, dt, method));
    const Frame& frame = run.frames.back();
    return std::pair{frame.bodies[0].position - frame.bodies[1].position,
                     run.resolution.configuration_error};
  };
  const Complex reference = end(reference_step, heun).first;
  const auto error = [&](double dt, SteppingMethod method) {
    const auto [distance, estimate] = end(dt, method);
    const double apart = std::abs(distance - reference);
    // The error of each body is half the error of the distance, and the radius is 1/2. The error of
    // the distance is therefore the error of one body relative to its radius.
    BOOST_TEST(apart < 10.0 * estimate, apart << ", estimated " << estimate);
    BOOST_TEST(estimate < (method == euler ? 20.0 : 1e3) * apart);
    return apart;
  };
  const auto order = [&](SteppingMethod method) {
    return std::log(error(long_step, method) / error(short_step, method)) /
           std::log(long_step / short_step);
  };
  BOOST_TEST(order(euler) >= 0.8);
  BOOST_TEST(order(heun) >= 1.5);
}

// Checks that the error after a contact that has begun and ended follows the tolerance.
void check_control(const std::vector<double>& tolerances, double reference_step) {
  Scene scene = passing_pair();
  scene.output.dt_write = 6.0;
  scene.solver.tolerance = 1e-6;
  const auto distance = [](const RecordedRun& run) {
    return run.frames.back().bodies[0].position - run.frames.back().bodies[1].position;
  };
  const Complex reference = distance(recorded_run(over(scene, 6.0, reference_step, heun)));
  long long steps = 0;
  for (const double tolerance : tolerances) {
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

}  // namespace

BOOST_AUTO_TEST_CASE(steps_with_contact_keep_their_order) {
  check_orders(0.2, 0.05, 0.0125);
}

BOOST_AUTO_TEST_CASE(short_steps_with_contact_keep_their_order, *boost::unit_test::label("full")) {
  check_orders(0.1, 0.025, 0.0025);
}

BOOST_AUTO_TEST_CASE(controlled_steps_are_no_longer_than_the_longest) {
  Scene scene = over(passing_pair(), 1.5, 0.05, heun);
  scene.time->tolerance = 0.1;  // without dt_max, this tolerance allows steps of 0.3
  scene.time->dt_max = 0.12;
  double longest = 0.0;
  for (const StepInfo& step : recorded_run(scene).steps) longest = std::max(longest, step.dt);
  BOOST_TEST(longest <= 0.12 * (1.0 + 1e-9));
  BOOST_TEST(longest > 0.1);
}

// The first step closes the gap from 0.8 to 0.1, against the contact force; later steps keep the
// gap.
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

// The torques of forces that act along no coordinate axis balance up to rounding. A sum of exactly
// 0 would mean that it was not computed.
BOOST_AUTO_TEST_CASE(net_torques_are_reported) {
  const RecordedRun run = recorded_run(over(head_on(0.05), 0.1, 0.1));
  for (const double torque :
       {run.steps.front().torque_imbalance, run.totals.largest_torque_imbalance}) {
    BOOST_TEST(torque > 0.0);
    BOOST_TEST(torque <= 1e-12);
  }
}

// A step that has contact at two instants reports the larger errors of both, the power of the last,
// and the energy that both put in.
BOOST_AUTO_TEST_CASE(a_step_reports_the_worst_of_its_contacts) {
  ContactOutcome first, last;
  first.kkt_residual = 3.0, first.imbalance = {1.0, 6.0}, first.result.power = 2.0;
  last.kkt_residual = 2.0, last.imbalance = {4.0, 5.0}, last.result.power = -7.0;
  const StepInfo step = with_forces(with_forces({}, first, 0.5), last, 0.5);
  BOOST_TEST(step.kkt_residual == 3.0);
  BOOST_TEST(step.force_imbalance == 4.0);
  BOOST_TEST(step.torque_imbalance == 6.0);
  BOOST_TEST(step.contact_power == -7.0);
  BOOST_TEST(step.energy_injected == 1.0);
}

BOOST_AUTO_TEST_CASE(totals_count_what_contact_takes) {
  const RecordedRun run = recorded_run(over(head_on(0.0), 0.3, 0.1));
  long long iterations = 0, matvecs = 0, linear_problems = 0;
  for (const StepInfo& step : run.steps) {
    iterations += step.gmres_iterations;
    matvecs += step.matvecs;
    linear_problems += step.ncp_iterations;
  }
  BOOST_TEST(linear_problems > 0);
  BOOST_TEST(run.totals.ncp_iterations >= linear_problems);
  BOOST_TEST(run.totals.contact_solves > 0);
  BOOST_TEST(run.totals.contact_seconds > 0.0);
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

// The error of an Euler step, estimated from the velocities at its ends, is its distance from the
// path, in radii.
BOOST_AUTO_TEST_CASE(the_error_of_an_euler_step_is_estimated) {
  const Scene scene = in_contact(ShearFlow{1.0},
                                 {body_at(Circle{0.5}, {-1.2, 0.5}, automatic_nodes),
                                  body_at(Circle{0.5}, {0.0, -0.5}, automatic_nodes)},
                                 0.05);
  const auto position = [](const RecordedRun& run) { return run.frames.back().bodies[0].position; };
  const Complex reference = position(recorded_run(over(scene, 0.1, 0.01, heun)));
  const RecordedRun run = recorded_run(over(scene, 0.1, 0.1, euler));
  BOOST_REQUIRE(run.steps.size() == 1U);
  const Complex difference = position(run) - reference;
  const double error = std::max(std::abs(difference.real()), std::abs(difference.imag())) / 0.5;
  BOOST_TEST(run.steps[0].contacts == 0);
  BOOST_TEST(error > 1e-4);
  BOOST_TEST(run.steps[0].step_error == error, boost::test_tools::tolerance(0.2));
}

// Disks that are driven along slightly offset lines slide past each other.
BOOST_AUTO_TEST_CASE(control_cuts_steps_that_forces_do_not_follow) {
  const auto end = [](const Scene& scene) { return recorded_run(scene).frames.back().bodies; };
  const auto reference = end(over(head_on(0.05), 0.1, 5e-4, heun));
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

BOOST_AUTO_TEST_CASE(errors_with_contact_follow_the_tolerance) {
  check_control({1e-2, 1e-3}, 0.0125);
}

BOOST_AUTO_TEST_CASE(errors_with_contact_follow_a_small_tolerance,
                     *boost::unit_test::label("full")) {
  check_control({1e-2, 1e-3, 1e-4}, 0.0025);
}

BOOST_AUTO_TEST_CASE(runs_with_contact_resume_bit_for_bit) {
  for (const bool adapted : {false, true}) resume_from_checkpoints(sliding_past(adapted));
}

// The disks begin at 0.6 separations, are pulled apart, and are pressed together from t = 0.3 on.
BOOST_AUTO_TEST_CASE(runs_with_close_pairs_resume_bit_for_bit) {
  resume_from_checkpoints(opened_and_pressed(0.3, 0.8));
}

// Without [time] there is no step: contact acts on the velocities of this instant.
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
  // There is no contact if the disks are driven together from gaps wider than the separation, nor
  // if they are pulled apart at the separation.
  for (const double gap : {2.0, 0.2, 0.12}) {
    BOOST_TEST(solved(gap, -1.0).contacts.empty());
    BOOST_TEST(solved(gap, -1.0).bodies[0].velocity.real() > 0.0);
  }
  BOOST_TEST(solved(0.1, 1.0).contacts.empty());
  const Frame held = solved(0.1, -1.0);
  BOOST_REQUIRE(held.contacts.size() == 1);
  // The gap is a tenth of the radius and mu = 1. The table in contact.cpp lists the force for
  // radius 1/2.
  BOOST_TEST(held.contacts[0].force == 2.0 * 9.61, boost::test_tools::tolerance(0.01));
  BOOST_TEST(std::abs(held.bodies[0].velocity) <
             1e-2 * solved(0.12, -1.0).bodies[0].velocity.real());
}

}  // namespace stokesbook::test
