// Tests the rejection of steps (chapter 09): steps that lead into an overlap, or too close for the
// nodes, are halved, down to time.dt_min. Step lengths chosen by the effort of the solver double
// and halve.

#include <boost/test/unit_test.hpp>

#include "support/known_motions.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/motion/free_steps.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

// The distance of the centres has D(0) = 4 and D'(0) = -2.97: a step of length 1 by Euler's method
// makes the unit circles overlap.
Scene approaching(const TimeSettings& time) {
  Scene scene;
  scene.flow = ExtensionalFlow{-1.0};
  scene.bodies = {body_at(Circle{1.0}, -2.0, automatic_nodes),
                  body_at(Circle{1.0}, 2.0, automatic_nodes)};
  scene.solver.tolerance = 1e-6;
  scene.time = time;
  scene.output.dt_write = time.t_final;
  return scene;
}

struct Taken {
  std::vector<double> ends, lengths;
  RunTotals totals;
  double distance = 0.0;  // of the centres, at the end
};

Taken steps_of(const Scene& scene) {
  Taken taken;
  Observer observer;
  observer.step = [&](const StepInfo& step) {
    taken.ends.push_back(step.t);
    taken.lengths.push_back(step.dt);
  };
  observer.frame = [&](const Frame& frame) {
    taken.distance = (frame.bodies[1].position - frame.bodies[0].position).real();
  };
  const SuspensionSolver solver(scene);
  Simulation simulation(solver, observer);
  simulation.run();
  taken.totals = simulation.totals();
  return taken;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fixed_steps_into_an_overlap_are_halved_and_come_back) {
  for (const SteppingMethod method : {euler, adams_bashforth2}) {
    const Taken taken = steps_of(approaching({2.0, 1.0, method}));
    BOOST_REQUIRE(taken.ends.size() >= 3);
    BOOST_TEST(taken.ends[0] == 0.5);
    BOOST_TEST(taken.ends[1] == 1.0);
    BOOST_TEST(taken.totals.rejected_steps >= 1);
    BOOST_TEST(taken.distance > 2.0);
  }
}

BOOST_AUTO_TEST_CASE(adapted_steps_into_an_overlap_are_halved_and_stay_accurate) {
  for (const SteppingMethod method : {bogacki_shampine32, dormand_prince54, prince_dormand87}) {
    const Taken taken = steps_of(approaching({2.0, 2.0, method, 1e-4}));
    BOOST_TEST(taken.totals.rejected_steps >= 1);
    BOOST_TEST(std::abs(taken.distance - circle_distance(4.0, 2.0)) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(an_overlap_that_no_short_step_avoids_stops_the_run) {
  TimeSettings time{2.0, 1.0, euler};
  time.dt_min = 0.6;
  const auto names_time_bodies_and_limit = [](const ConfigurationError& error) {
    const std::string message = error.what();
    return message.starts_with("t = 1: ") && message.find("body 0") != std::string::npos &&
           message.find("time.dt_min = 0.6") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(steps_of(approaching(time)), ConfigurationError,
                        names_time_bodies_and_limit);
}

// Two disks in contact come closer than their nodes resolve. The time at the end of the least step
// is rounded upwards for some of these lengths and downwards for others.
BOOST_AUTO_TEST_CASE(with_contact_the_least_step_is_the_last_try) {
  for (const double dt_min : {7e-4, 1.1e-3, 2.3e-3, 3.1e-3, 5e-3}) {
    TimeSettings time{3.0, 0.1, euler};
    time.dt_min = dt_min;
    Scene scene = approaching(time);
    for (Body& body : scene.bodies) body.n_nodes = 32;
    scene.solver.tolerance = 1e-4;
    scene.contact = ContactSettings{1e-4};
    const auto says_when_and_what = [](const SolverError& error) {
      const std::string message = error.what();
      return message.starts_with("t = ") && message.find("t = ", 1) == std::string::npos &&
             message.find("body 0") != std::string::npos &&
             message.find("time.dt_min = ") != std::string::npos;
    };
    BOOST_CHECK_EXCEPTION(steps_of(scene), SolverError, says_when_and_what);
  }
}

// Two disks that are pressed together never meet. A step that would exchange their sides is halved,
// and the run stops if the least step would still do so.
BOOST_AUTO_TEST_CASE(bodies_do_not_pass_through_each_other_within_a_step) {
  for (const SteppingMethod method : {euler, heun, rk4, dormand_prince54}) {
    Scene scene;
    scene.gauge_length = 100.0;
    scene.bodies = {body_at(Circle{0.5}, -1.5, automatic_nodes),
                    body_at(Circle{0.5}, 1.5, automatic_nodes)};
    scene.bodies[0].force = 100.0;
    scene.bodies[1].force = -100.0;
    scene.solver.tolerance = 1e-4;
    scene.time = {.t_final = 1.0, .dt = 0.5, .method = method, .dt_min = 0.4};
    scene.output.dt_write = 0.5;
    if (method == dormand_prince54) {
      scene.time->dt.reset();
      scene.time->tolerance = 0.1;
    }
    double nearest = 0.0;
    std::string stopped;
    try {
      Observer observer;
      observer.frame = [&](const Frame& frame) {
        const double side = (frame.bodies[1].position - frame.bodies[0].position).real();
        BOOST_TEST(side > 1.0);
        nearest = side;
      };
      const SuspensionSolver solver(scene);
      Simulation(solver, observer).run();
    } catch (const SolverError& error) {
      stopped = error.what();
    }
    if (method != dormand_prince54)
      BOOST_TEST(stopped.find("body 0 and body 1") != std::string::npos, stopped);
  }
}

// PassingTest admits paths on which the bodies do not overlap. Here, two disks pass each other.
BOOST_AUTO_TEST_CASE(paths_beside_each_other_are_admitted) {
  Scene scene;
  scene.bodies = {body_at(Circle{0.5}, {-2.0, 0.501}, 64), body_at(Circle{0.5}, {2.0, -0.501}, 64)};
  const SuspensionSolver solver(scene);
  const PassingTest test(solver);
  const Configuration start = solver.start().configuration;
  Configuration end = start;
  std::swap(end[0].position, end[1].position);
  for (Pose& pose : end) pose.position = std::conj(pose.position);
  BOOST_TEST(test.describe_passing(start, end, 3.0) == "");
  for (Pose& pose : end) pose.position = pose.position.real();
  BOOST_TEST(test.describe_passing(start, end, 3.0)
                 .starts_with("body 0 and body 1 overlap or pass through"));
  BOOST_TEST(test.describe_passing(start, end, 9.0) == "");  // a least gap of 9 requires no search
}

BOOST_AUTO_TEST_CASE(steps_too_close_for_given_nodes_are_halved) {
  // One step would leave a gap of 0.04; two halves leave a gap of 0.4.
  Scene scene = approaching({0.66, 0.66, euler});
  for (Body& body : scene.bodies) body.n_nodes = 48;
  const Taken taken = steps_of(scene);
  BOOST_TEST(taken.totals.rejected_steps == 1);
  BOOST_TEST(taken.distance > 2.2);
}

BOOST_AUTO_TEST_CASE(a_tolerance_beyond_the_least_step_stops_the_run) {
  TimeSettings time{2.0, 0.5, dormand_prince54, 1e-10};
  time.dt_min = 0.4;
  const auto names_time_and_limit = [](const SolverError& error) {
    const std::string message = error.what();
    return message.starts_with("t = 0: the estimated error of a step of 0.5 is ") &&
           message.find("time.dt_min = 0.4") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(steps_of(approaching(time)), SolverError, names_time_and_limit);
}

BOOST_AUTO_TEST_CASE(steps_by_effort_double_and_halve_within_their_limits) {
  TimeSettings time{0.15, 0.01, euler};
  time.dt_max = 0.04;
  time.effort = EffortBounds{1000, 2000};
  const std::vector<double> growing{0.01, 0.02, 0.04, 0.04, 0.04};
  BOOST_TEST(steps_of(approaching(time)).lengths == growing,
             boost::test_tools::tolerance(1e-9) << boost::test_tools::per_element());
  time = {0.045, 0.02, euler};
  time.dt_min = 0.005;
  time.effort = EffortBounds{1, 2};
  const std::vector<double> shrinking{0.015, 0.01, 0.005, 0.005, 0.005, 0.005};
  BOOST_TEST(steps_of(approaching(time)).lengths == shrinking,
             boost::test_tools::tolerance(1e-9) << boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_rejected_try_counts_by_what_it_cost) {
  const auto solved = [](int matvecs, double residual) {
    Solution solution;
    solution.cost.gmres_iterations = matvecs - 1;
    solution.cost.matvecs = matvecs;
    solution.gmres.residual = residual;
    return solution;
  };
  const StepInfo begun = begin_step(solved(10, 1e-7), 0.5);
  ContactOutcome outcome;
  outcome.imbalance.force = 1e-16;
  outcome.result.iterations = 3;
  const StepInfo tried = with_solve(begun, solved(20, 1e-6), 0.25);
  const SolveCost responses{.gmres_iterations = 5, .matvecs = 7};
  const StepInfo rejected =
      with_forces(with_contact(tried, outcome, responses, 0.125), outcome, 1.0);
  const StepInfo step = with_costs_of(begun, rejected);
  BOOST_TEST(step.gmres_iterations == 33);
  BOOST_TEST(step.matvecs == 37);
  BOOST_TEST(step.residual == 1e-6);  // the largest residual of all solves of the step
  BOOST_TEST(step.seconds == 0.875);
  BOOST_TEST(step.ncp_iterations == 0);
  BOOST_TEST(step.force_imbalance == 0.0);
}

}  // namespace stokesbook::test
