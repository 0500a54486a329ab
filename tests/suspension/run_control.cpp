// A run hits written times, reversals and its end exactly, goes back along its path after a
// reversal, resumes bit for bit, carries walls with their motion, and stops with the time in the
// message when it must.

#include <numbers>

#include <boost/test/unit_test.hpp>

#include "suspension/numerics_refused.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

Scene sheared_pair() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {body_at(Ellipse{1.0, 0.6}, {-2.0, 0.5}, 48),
                  body_at(Circle{0.8}, {1.5, -0.4}, 32)};
  scene.solver.tolerance = 1e-4;
  scene.time = TimeSettings{1.0, 0.07, SteppingMethod::adams_bashforth2};
  scene.output.dt_write = 0.25;
  return scene;
}

bool same(const BodyState& a, const BodyState& b) {
  return a.position == b.position && a.orientation == b.orientation && a.velocity == b.velocity &&
         a.omega == b.omega;
}

}  // namespace

BOOST_AUTO_TEST_CASE(written_times_reversals_and_the_end_are_hit_exactly) {
  Scene scene = sheared_pair();
  scene.reverse_at = {0.6};
  std::vector<double> written, steps;
  const SuspensionSolver solver(scene);
  Observer observer;
  observer.frame = [&](const Frame& frame) { written.push_back(frame.t); };
  observer.step = [&](const StepInfo& step) {
    steps.push_back(step.t);
    BOOST_TEST(step.dt <= 0.07 * (1.0 + 1e-9));
  };
  Simulation(solver, observer).run();
  const std::vector<double> expected{0.0, 0.25, 0.5, 0.75, 1.0};
  BOOST_TEST(written == expected, boost::test_tools::per_element());
  BOOST_TEST((std::find(steps.begin(), steps.end(), 0.6) != steps.end()));
}

BOOST_AUTO_TEST_CASE(a_reversed_run_comes_back) {
  Scene scene = sheared_pair();
  scene.time = TimeSettings{2.0, 0.05, SteppingMethod::rk4};
  scene.reverse_at = {1.0};
  const std::vector<Frame> frames = frames_of(scene);
  for (std::size_t k = 0; k < 2; ++k) {
    // Stokes flow is reversible; what remains is the steps' own error, of order dt^4.
    BOOST_TEST(std::abs(frames.back().bodies[k].position - scene.bodies[k].position) < 1e-7);
    BOOST_TEST(std::abs(frames.back().bodies[k].orientation) < 1e-7);
    BOOST_TEST(std::abs(frames[4].bodies[k].position - scene.bodies[k].position) > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_resumed_run_continues_bit_for_bit) {
  const Scene scene = sheared_pair();
  const SuspensionSolver solver(scene);
  std::vector<Frame> frames, resumed;
  std::vector<Checkpoint> checkpoints;
  Observer observer;
  observer.frame = [&](const Frame& frame) { frames.push_back(frame); };
  observer.checkpoint = [&](const Checkpoint& reached) { checkpoints.push_back(reached); };
  Simulation(solver, observer).run();
  observer = {};
  observer.frame = [&](const Frame& frame) { resumed.push_back(frame); };
  Simulation simulation(solver, observer);
  simulation.resume(checkpoints.at(2));
  simulation.run();
  BOOST_REQUIRE_EQUAL(resumed.size() + 3, frames.size());
  for (std::size_t i = 0; i < resumed.size(); ++i) {
    BOOST_TEST(resumed[i].t == frames[i + 3].t);
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(same(resumed[i].bodies[k], frames[i + 3].bodies[k]));
    }
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
  // 1.5 forward, 0.5 back.
  BOOST_TEST(std::abs(end.bodies[0].position - Complex(1.5, 0.2)) < 1e-14);
  BOOST_TEST(std::abs(end.bodies[0].orientation + 0.3) < 1e-14);
  BOOST_TEST(std::abs(end.walls[0].orientation - 0.5) < 1e-14);
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
  const auto names_time_and_bodies = [](const NumericsRefused& refusal) {
    const std::string message = refusal.what();
    return message.starts_with("t = ") && message.find("body 0") != std::string::npos &&
           message.find("body 1") != std::string::npos &&
           message.find("n_nodes") != std::string::npos;
  };
  Simulation simulation(solver, observer);
  BOOST_CHECK_EXCEPTION(simulation.run(), NumericsRefused, names_time_and_bodies);
  BOOST_TEST(last_written > 0.5);
  BOOST_TEST(last_written < 3.0);
}

}  // namespace stokesbook::test
