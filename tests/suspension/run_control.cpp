// Tests the control of runs (chapter 12): a run reaches written times, reversals and its end
// exactly, returns along its path after a reversal, resumes bit for bit, and moves walls as
// prescribed. A run that stops with an error reports the time.

#include <cmath>
#include <numbers>
#include <set>

#include <boost/test/unit_test.hpp>

#include "support/touching.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

Scene sheared_pair(SteppingMethod method = SteppingMethod::adams_bashforth2) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {body_at(Ellipse{1.0, 0.6}, {-2.0, 0.5}, 48),
                  body_at(Circle{0.8}, {1.5, -0.4}, 32)};
  scene.solver.tolerance = 1e-4;
  scene.time = TimeSettings{1.0, 0.07, method};
  scene.output.dt_write = 0.25;
  return scene;
}

constexpr SteppingMethod methods[] = {SteppingMethod::euler,
                                      SteppingMethod::adams_bashforth2,
                                      SteppingMethod::heun,
                                      SteppingMethod::rk4,
                                      SteppingMethod::bogacki_shampine32,
                                      SteppingMethod::dormand_prince54,
                                      SteppingMethod::prince_dormand87};

bool same(const BodyState& a, const BodyState& b) {
  return a.position == b.position && a.orientation == b.orientation && a.velocity == b.velocity &&
         a.omega == b.omega;
}

bool same(const StepInfo& a, const StepInfo& b) {
  return a.t == b.t && a.dt == b.dt && a.gmres_iterations == b.gmres_iterations &&
         a.matvecs == b.matvecs && a.min_gap == b.min_gap && a.residual == b.residual &&
         a.velocity_error == b.velocity_error && a.step_error == b.step_error;
}

struct Recorded {
  std::vector<Frame> frames;
  std::vector<StepInfo> steps;
  RunResolution resolution;
};

// Runs to the end, from a checkpoint if there is one, and collects the checkpoints of the run.
Recorded record(const SuspensionSolver& solver, const std::optional<Checkpoint>& from,
                std::vector<Checkpoint>* checkpoints) {
  Recorded recorded;
  Observer observer;
  observer.frame = [&](const Frame& frame) { recorded.frames.push_back(frame); };
  observer.step = [&](const StepInfo& step) { recorded.steps.push_back(step); };
  if (checkpoints) {
    observer.checkpoint = [=](const Checkpoint& reached) { checkpoints->push_back(reached); };
  }
  Simulation simulation(solver, observer);
  if (from) simulation.resume(*from);
  simulation.run();
  recorded.resolution = simulation.resolution();
  return recorded;
}

// Resumes a run at each of its frames.
void expect_same_bits_after_resuming(const Scene& scene) {
  const SuspensionSolver solver(scene);
  std::vector<Checkpoint> checkpoints;
  const Recorded whole = record(solver, {}, &checkpoints);
  BOOST_REQUIRE_EQUAL(checkpoints.size(), whole.frames.size());
  for (std::size_t first = 1; first < checkpoints.size(); ++first) {
    const Recorded rest = record(solver, checkpoints[first - 1], nullptr);
    BOOST_REQUIRE_EQUAL(rest.frames.size() + first, whole.frames.size());
    for (std::size_t i = 0; i < rest.frames.size(); ++i) {
      BOOST_TEST(rest.frames[i].t == whole.frames[i + first].t);
      for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        BOOST_TEST(same(rest.frames[i].bodies[k], whole.frames[i + first].bodies[k]));
      }
    }
    BOOST_TEST(rest.resolution.first_nodes == whole.resolution.first_nodes);
    BOOST_TEST(rest.resolution.most_nodes == whole.resolution.most_nodes);
    BOOST_TEST(rest.resolution.velocity_error == whole.resolution.velocity_error);
    BOOST_TEST(rest.resolution.configuration_error == whole.resolution.configuration_error);
    const std::size_t skipped = whole.steps.size() - rest.steps.size();
    for (std::size_t i = 0; i < rest.steps.size(); ++i) {
      BOOST_TEST(same(rest.steps[i], whole.steps[i + skipped]));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(written_times_reversals_and_the_end_are_hit_exactly) {
  for (const SteppingMethod method : methods) {
    Scene scene = sheared_pair(method);
    scene.reverse_at = {0.6};
    std::vector<double> written, steps;
    const SuspensionSolver solver(scene);
    Observer observer;
    observer.frame = [&](const Frame& frame) { written.push_back(frame.t); };
    observer.step = [&](const StepInfo& step) {
      steps.push_back(step.t);
      if (!is_embedded(method)) BOOST_TEST(step.dt <= 0.07 * (1.0 + 1e-9));
    };
    Simulation(solver, observer).run();
    const std::vector<double> expected{0.0, 0.25, 0.5, 0.75, 1.0};
    BOOST_TEST(written == expected, boost::test_tools::per_element());
    BOOST_TEST((std::find(steps.begin(), steps.end(), 0.6) != steps.end()));
    BOOST_TEST(steps.back() == 1.0);
  }
}

// In floating point, three times 0.1 is not 0.3. A step between these two times would have a length
// of rounding errors, from which the Adams-Bashforth method would compute a rate.
BOOST_AUTO_TEST_CASE(events_that_differ_by_rounding_are_one) {
  for (const SteppingMethod method : methods) {
    Scene scene = sheared_pair(method);
    scene.output.dt_write = 0.1;
    for (const double reversal : {0.3, 0.6, 0.7}) {
      scene.time->t_final = 2.0 * reversal;
      scene.reverse_at = {reversal};
      const SuspensionSolver solver(scene);
      const Recorded run = record(solver, {}, nullptr);
      const auto frames = static_cast<std::size_t>(std::lround(20.0 * reversal)) + 1;
      BOOST_REQUIRE(run.frames.size() == frames);
      for (std::size_t k = 0; k < run.frames.size(); ++k) {
        BOOST_TEST(std::abs(run.frames[k].t - 0.1 * static_cast<double>(k)) < 1e-12);
      }
      for (const StepInfo& step : run.steps) BOOST_TEST(step.dt > 1e-3);
      const BodyState &start = run.frames.front().bodies[0], &end = run.frames.back().bodies[0];
      BOOST_TEST(std::abs(end.position - start.position) < 0.03);
      BOOST_TEST(std::abs(end.orientation) < 0.03);
    }
  }
}

// Three times 0.3 is less than 0.9 by rounding: the frame of the end is that of the third multiple.
BOOST_AUTO_TEST_CASE(the_end_is_written_once_if_a_multiple_differs_by_rounding) {
  const auto expect_four_frames = [](const Scene& scene) {
    std::vector<double> times;
    for (const Frame& frame : record(SuspensionSolver(scene), {}, nullptr).frames) {
      times.push_back(frame.t);
    }
    const std::vector<double> expected{0.0, 0.3, 0.6, 0.9};
    BOOST_TEST(times == expected, boost::test_tools::per_element());
  };
  for (const SteppingMethod method : methods) {
    Scene scene = sheared_pair(method);
    scene.time->t_final = 0.9;
    scene.output.dt_write = 0.3;
    expect_four_frames(scene);
    if (method != SteppingMethod::euler && method != SteppingMethod::heun) continue;
    scene.contact = ContactSettings{.minimum_separation = 0.1};
    expect_four_frames(scene);
  }
}

BOOST_AUTO_TEST_CASE(euler_solves_once_at_the_start_and_at_the_end_of_each_step) {
  const SuspensionSolver solver(sheared_pair(SteppingMethod::euler));
  Simulation simulation(solver, {});
  simulation.run();
  BOOST_TEST(simulation.totals().steps > 1);
  BOOST_TEST(simulation.totals().solves == simulation.totals().steps + 1);
}

BOOST_AUTO_TEST_CASE(steps_with_an_interpolant_pass_written_times) {
  Scene scene = sheared_pair(SteppingMethod::dormand_prince54);
  scene.time->dt.reset();
  const auto totals_of = [](const Scene& some) {
    const SuspensionSolver solver(some);
    Simulation simulation(solver, {});
    simulation.run();
    return simulation.totals();
  };
  scene.output.dt_write = 1.0;
  const RunTotals few = totals_of(scene);
  scene.output.dt_write = 0.01;
  const RunTotals many = totals_of(scene);
  BOOST_TEST(many.steps == few.steps);
  BOOST_TEST(many.solves == few.solves + 99);  // one solve for each time between start and end
}

BOOST_AUTO_TEST_CASE(a_reversed_run_comes_back) {
  Scene scene = sheared_pair();
  scene.time = TimeSettings{2.0, 0.05, SteppingMethod::rk4};
  scene.reverse_at = {1.0};
  const std::vector<Frame> frames = frames_of(scene);
  for (std::size_t k = 0; k < 2; ++k) {
    // Stokes flow is reversible, so only the error of the steps, of order dt^4, remains.
    BOOST_TEST(std::abs(frames.back().bodies[k].position - scene.bodies[k].position) < 1e-7);
    BOOST_TEST(std::abs(frames.back().bodies[k].orientation) < 1e-7);
    BOOST_TEST(std::abs(frames[4].bodies[k].position - scene.bodies[k].position) > 0.1);
  }
}

// If one of these lists changes, the format requires a new number in record/checkpoint.cpp.
BOOST_AUTO_TEST_CASE(the_number_of_the_format_stands_for_what_a_checkpoint_holds) {
  const auto names_of = [](const Scene& scene) {
    const SuspensionSolver solver(scene);
    std::vector<Checkpoint> checkpoints;
    record(solver, {}, &checkpoints);
    std::set<std::string> names;  // names of lists, without the numbers of their entries
    for (const auto& [name, values] : checkpoints.back().history) {
      names.insert(name.substr(0, name.find_last_not_of("_0123456789") + 1));
    }
    std::string text;
    for (const std::string& name : names) text += name + ' ';
    return text;
  };
  BOOST_TEST(to_text({}).starts_with("stokesbook checkpoint 7\n"));
  Scene scene = sheared_pair();
  BOOST_TEST(
      names_of(scene) ==
      "contact_flows contact_loads contact_time contact_tolerances contact_totals contact_velocity "
      "density drift_load error errors estimate first_nodes largest_estimate most_nodes "
      "nodes_in_contact "
      "previous_dt previous_rate stage_deviation stage_dt steps_in_contact written ");
  scene.contact = ContactSettings{.minimum_separation = 0.01};
  scene.time->method = SteppingMethod::heun;
  scene.time->tolerance = 1e-2;
  BOOST_TEST(names_of(scene) ==
             "closer contact_flows contact_loads contact_time contact_tolerances contact_totals "
             "contact_velocity density drift_load dt error errors estimate first_nodes "
             "largest_estimate most_nodes "
             "nodes_in_contact stage_deviation stage_dt steps_in_contact written ");
}

BOOST_AUTO_TEST_CASE(a_checkpoint_that_lacks_something_is_refused) {
  const SuspensionSolver solver(sheared_pair());
  std::vector<Checkpoint> checkpoints;
  record(solver, {}, &checkpoints);
  for (const char* name : {"contact_tolerances", "estimate", "most_nodes", "written"}) {
    Checkpoint checkpoint = checkpoints[1];
    BOOST_TEST(checkpoint.history.erase(name) == 1u);
    Simulation simulation(solver, {});
    BOOST_CHECK_THROW(simulation.resume(checkpoint), std::out_of_range);
  }
}

BOOST_AUTO_TEST_CASE(a_run_resumed_at_any_frame_continues_bit_for_bit) {
  for (const SteppingMethod method : methods) {
    Scene scene = sheared_pair(method);
    scene.reverse_at = {0.6};
    expect_same_bits_after_resuming(scene);
  }
}

// The stages of a step share its tree of groups, which a resumed run builds again.
BOOST_AUTO_TEST_CASE(a_run_in_trees_continues_bit_for_bit) {
  for (const SteppingMethod method : {SteppingMethod::heun, SteppingMethod::dormand_prince54}) {
    Scene scene = with_preconditioner(disk_hexagon(1, 0.1, 1e-4), PreconditionerKind::hierarchical);
    scene.time = TimeSettings{0.1, 0.02, method};
    scene.output.dt_write = 0.04;
    expect_same_bits_after_resuming(scene);
  }
}

// A step depends on the end of the run if no written time or reversal precedes the end.
BOOST_AUTO_TEST_CASE(steps_after_the_last_event_depend_on_the_end) {
  const auto first_dependent = [](const Scene& scene) {
    const OutputSchedule schedule(scene);
    double t = 0.0;
    while (!schedule.depends_on_end(t)) t = schedule.next_event(t);
    return t;
  };
  Scene scene = sheared_pair(SteppingMethod::heun);
  BOOST_TEST(first_dependent(scene) == 0.75);
  scene.reverse_at = {0.8, 1.0};
  BOOST_TEST(first_dependent(scene) == 0.8);
  scene.time->method = SteppingMethod::dormand_prince54;
  BOOST_TEST(first_dependent(scene) == 0.8);
  scene.reverse_at = {};
  BOOST_TEST(first_dependent(scene) == 0.0);
  scene.time->method = SteppingMethod::heun;
  scene.output.dt_write.reset();
  BOOST_TEST(first_dependent(scene) == 0.0);
}

// Written times are multiples of the interval up to rounding, however short or long it is.
BOOST_AUTO_TEST_CASE(times_between_multiples_are_not_written) {
  for (const double interval : {1e-6, 1.0, 1e6}) {
    Scene scene = sheared_pair(SteppingMethod::heun);
    scene.time->t_final = 10.0 * interval;
    scene.output.dt_write = interval;
    const OutputSchedule schedule(scene);
    BOOST_TEST(schedule.is_written(3.0 * interval));
    for (const double aside : {-1e-10, 1e-10}) {
      BOOST_TEST(schedule.is_written((3.0 + aside) * interval));
    }
    for (const double aside : {-1e-8, 1e-8, 0.5}) {
      BOOST_TEST(!schedule.is_written((3.0 + aside) * interval));
    }
  }
}

// Settings change nothing where the run is, and the contact of the new settings is checked.
BOOST_AUTO_TEST_CASE(a_run_goes_on_with_other_settings) {
  Scene scene = sheared_pair();
  std::vector<Checkpoint> checkpoints;
  const SuspensionSolver solver(scene);
  const Recorded before = record(solver, {}, &checkpoints);
  scene.time = TimeSettings{2.0, 0.1, SteppingMethod::rk4};
  scene.solver.tolerance = 1e-6;
  const SuspensionSolver other(scene);
  std::vector<Frame> frames;
  Observer observer;
  observer.frame = [&](const Frame& frame) { frames.push_back(frame); };
  Simulation simulation(other, observer);
  simulation.continue_from(checkpoints.back());
  BOOST_TEST(simulation.checkpoint().t == 1.0);
  BOOST_TEST(simulation.checkpoint().step == checkpoints.back().step);
  BOOST_TEST(simulation.checkpoint().state == checkpoints.back().state);
  simulation.run();
  BOOST_REQUIRE(frames.size() == 4U);
  BOOST_TEST(frames.front().t == 1.25);
  BOOST_TEST(simulation.totals().steps > checkpoints.back().step);
  // The same from a scene that starts there: Runge and Kutta's steps have no memory.
  for (std::size_t k = 0; k < 2; ++k) {
    scene.bodies[k].position = before.frames.back().bodies[k].position;
    scene.bodies[k].orientation = before.frames.back().bodies[k].orientation;
  }
  scene.time->t_final = 1.0;
  const Frame end = frames_of(scene).back();
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(std::abs(end.bodies[k].position - frames.back().bodies[k].position) < 1e-5);
    BOOST_TEST(std::abs(end.bodies[k].orientation - frames.back().bodies[k].orientation) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(walls_and_held_bodies_move_as_prescribed) {
  Scene scene;
  scene.walls = {{WallRole::outer, Circle{5.0}, {}, 0.0, 96, RotatingWall{0.5}}};
  scene.bodies = {body_at(Ellipse{0.8, 0.5}, 1.5, 48)};
  scene.bodies[0].held = true;
  scene.bodies[0].velocity = {0.0, 0.2};
  scene.bodies[0].omega = -0.3;
  scene.solver.tolerance = 1e-4;
  scene.time = TimeSettings{2.0, 0.5, SteppingMethod::euler};
  scene.reverse_at = {1.5};
  const Frame end = frames_of(scene).back();
  // The motion is 1.5 forwards and 0.5 backwards.
  BOOST_TEST(std::abs(end.bodies[0].position - Complex(1.5, 0.2)) < 1e-14);
  BOOST_TEST(std::abs(end.bodies[0].orientation + 0.3) < 1e-14);
  BOOST_TEST(std::abs(end.walls[0].orientation - 0.5) < 1e-14);
}

BOOST_AUTO_TEST_CASE(only_embedded_methods_choose_their_first_step) {
  for (const SteppingMethod method : methods) {
    Scene scene = sheared_pair(method);
    scene.time->dt = {};
    const SuspensionSolver solver(scene);
    if (is_embedded(method)) {
      BOOST_CHECK_NO_THROW(Simulation(solver, Observer{}));
    } else {
      BOOST_CHECK_THROW(Simulation(solver, Observer{}), std::invalid_argument);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_cannot_go_on_says_when_and_why) {
  Scene scene;
  scene.flow = ExtensionalFlow{-1.0};
  scene.bodies = {body_at(Circle{1.0}, -2.0, 64), body_at(Circle{1.0}, 2.0, 64)};
  scene.time = TimeSettings{3.0, 0.05, SteppingMethod::rk4};
  const SuspensionSolver solver(scene);
  double last_written = -1.0;
  Observer observer;
  observer.frame = [&](const Frame& frame) { last_written = frame.t; };
  const auto names_time_and_bodies = [](const SolverError& error) {
    const std::string message = error.what();
    return message.starts_with("t = ") && message.find("body 0") != std::string::npos &&
           message.find("body 1") != std::string::npos &&
           message.find("n_nodes") != std::string::npos;
  };
  Simulation simulation(solver, observer);
  BOOST_CHECK_EXCEPTION(simulation.run(), SolverError, names_time_and_bodies);
  BOOST_TEST(last_written > 0.5);
  BOOST_TEST(last_written < 3.0);
}

}  // namespace stokesbook::test
