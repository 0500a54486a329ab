// Tests tracers: circular paths in closed form, the orders of the steppers, bodies that they do not
// enter, contact forces that move the fluid, and runs that resume bit for bit.

#include "suspension/solver/tracers.hpp"

#include <cmath>

#include <boost/test/unit_test.hpp>

#include "suspension/contact_setup.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

// The empty cell between circles of radii 1 and 2.5 turns with the angular velocity A + B / r^2.
Scene couette_cell(SteppingMethod method, double dt) {
  const double inner = 1.5, outer = -0.4;
  Scene scene;
  scene.walls = {{.role = WallRole::inner, .shape = Circle{1.0}, .motion = RotatingWall{inner}},
                 {.role = WallRole::outer, .shape = Circle{2.5}, .motion = RotatingWall{outer}}};
  scene.tracers = {{1.2, 0.0}, {0.0, 1.7}, {-2.3, 0.1}};
  scene.solver.tolerance = 1e-12;
  scene.time = TimeSettings{1.0, dt, method};
  scene.output.dt_write = 1.0;
  return scene;
}

Complex turned_tracer(Complex start) {
  const double a2 = 1.0, b2 = 6.25, inner = 1.5, outer = -0.4;
  const double a = (outer * b2 - inner * a2) / (b2 - a2), b = (inner - outer) * a2 * b2 / (b2 - a2);
  return start * std::polar(1.0, a + b / std::norm(start));
}

double largest_error(const Scene& scene) {
  const Frame end = frames_of(scene).back();
  double error = 0.0;
  for (std::size_t k = 0; k < scene.tracers.size(); ++k) {
    error = std::max(error, std::abs(end.tracers.at(k) - turned_tracer(scene.tracers[k])));
  }
  return error;
}

// Returns disks that forces press together at the separation, or pull apart, with a tracer beside
// their gap.
Scene pressed(SteppingMethod method, bool pulled_apart) {
  Scene scene = pressed_disks();
  if (pulled_apart) std::swap(scene.bodies[0].force, scene.bodies[1].force);
  scene.tracers = {{0.0, 0.4}};
  return over(scene, 0.3, 0.1, method);
}

Scene pair_with_tracers(SteppingMethod method) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {body_at(Ellipse{1.0, 0.6}, {-2.0, 0.5}, 48),
                  body_at(Circle{0.8}, {1.5, -0.4}, 32)};
  scene.tracers = {{0.0, 0.0}, {-3.2, 0.4}, {1.5, 0.6}};
  scene.solver.tolerance = 1e-4;
  scene.time = TimeSettings{1.0, 0.07, method};
  scene.output.dt_write = 0.25;
  return scene;
}

// Checks that a run which continues from each of its checkpoints writes the same later frames.
void check_resumes(const Scene& scene) {
  const SuspensionSolver solver(scene);
  std::vector<Checkpoint> checkpoints;
  std::vector<Frame> whole;
  Simulation(solver, {.frame = [&](const Frame& frame) { whole.push_back(frame); },
                      .step = {},
                      .checkpoint = [&](const Checkpoint& c) { checkpoints.push_back(c); },
                      .warning = {}})
      .run();
  for (std::size_t k = 0; k + 1 < checkpoints.size(); ++k) {
    std::size_t next = k + 1;
    const auto compare = [&](const Frame& frame) {
      const Frame& other = whole.at(next++);
      BOOST_TEST((frame.tracers == other.tracers));
      BOOST_TEST((frame.bodies[0].position == other.bodies[0].position));
    };
    Simulation resumed(solver, {.frame = compare, .step = {}, .checkpoint = {}, .warning = {}});
    resumed.resume(checkpoints[k]);
    resumed.run();
    BOOST_TEST(next == whole.size());
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tracers)

BOOST_AUTO_TEST_CASE(circles_have_the_order_of_the_stepper) {
  const auto check_order = [](SteppingMethod method, double dt, double order) {
    const double ratio =
        largest_error(couette_cell(method, dt)) / largest_error(couette_cell(method, 0.5 * dt));
    BOOST_TEST(std::abs(std::log2(ratio) - order) < 0.15, std::log2(ratio));
  };
  check_order(euler, 0.01, 1.0);
  check_order(adams_bashforth2, 0.02, 2.0);
  check_order(heun, 0.05, 2.0);
  check_order(rk4, 0.1, 4.0);
  Scene adaptive = couette_cell(dormand_prince54, 0.1);
  adaptive.time->tolerance = 1e-9;
  BOOST_TEST(largest_error(adaptive) < 1e-8);
}

// With an interpolant, tracers have its accuracy at written times within a step.
BOOST_AUTO_TEST_CASE(frames_within_a_step) {
  Scene scene = couette_cell(dormand_prince54, 0.1);
  scene.time->tolerance = 1e-7;
  scene.time->t_final = 1.5;
  scene.output.dt_write = 0.5;
  const std::vector<Frame> frames = frames_of(scene);
  BOOST_REQUIRE(frames.size() == 4u);
  for (std::size_t k = 0; k < 3; ++k) {
    BOOST_TEST(std::abs(frames[2].tracers[k] - turned_tracer(scene.tracers[k])) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(points_outside_the_fluid_are_left_out) {
  Scene scene = couette_cell(rk4, 0.1);
  scene.tracers = {{0.5, 0.0}, {2.0, 0.0}, {2.0, 2.0}};
  const SuspensionSolver solver(scene);
  const Eigen::VectorXd state = initial_state(solver);
  BOOST_TEST(state.size() == 3 * 2 + 2);
  BOOST_TEST(tracers_of(solver, state)[0] == Complex(2.0, 0.0));
  BOOST_TEST(configuration_of(solver, state).size() == 2u);
}

// The disk moves towards a tracer. The fluid at the tracer is slower than the disk, which a long
// step of Euler's method would drive onto the tracer.
BOOST_AUTO_TEST_CASE(no_body_takes_a_tracer_in) {
  Scene scene;
  scene.walls = {{.role = WallRole::outer, .shape = Circle{8.0}}};
  scene.bodies = {held(Circle{1.0}, -2.0)};
  scene.bodies[0].velocity = 1.0;
  scene.tracers = {{2.0, 0.1}};
  scene.solver.tolerance = 1e-4;
  scene.time = TimeSettings{5.0, 5.0, euler};
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST(run.totals.rejected_steps > 0);
  for (const Frame& frame : run.frames) {
    BOOST_TEST(std::abs(frame.tracers[0] - frame.bodies[0].position) > 0.999);
  }
  scene.time->dt_min = 5.0;
  const RecordedRun stopped = recorded_run(scene, Refusals::recorded);
  BOOST_TEST(stopped.stopped.find("tracer 0 enters body 0") != std::string::npos);
}

// Errors take tracers that start next to a boundary into the component, and they move with it.
BOOST_AUTO_TEST_CASE(tracers_next_to_a_boundary) {
  constexpr double next_to = 1e-7;
  Scene scene = couette_cell(rk4, 0.1);
  scene.bodies = {turned(Circle{0.3}, {1.7, 0.0}, 0.0)};
  scene.tracers = {{2.0 + next_to, 0.0},
                   {1.4 - next_to, 0.0},
                   {1.7, 0.3 + next_to},
                   {2.5 - next_to, 0.0},
                   {-1.0 - next_to, 0.0}};
  scene.solver.tolerance = 1e-3;
  const Frame end = frames_of(scene).back();
  const auto& [position, orientation, velocity, omega, force, torque] = end.bodies[0];
  BOOST_REQUIRE(end.tracers.size() == 5u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Complex arm = std::polar(1.0, orientation) * (scene.tracers[k] - 1.7);
    BOOST_TEST(std::abs(end.tracers[k] - position - arm) < 0.01);
  }
  BOOST_TEST(std::abs(end.tracers[3] - std::polar(2.5, -0.4)) < 0.01);
  BOOST_TEST(std::abs(end.tracers[4] + std::polar(1.0, 1.5)) < 0.01);
}

// Contact forces cancel the loads that press the disks together: all is at rest, the tracer too.
// Forces that pull the disks apart move it.
BOOST_AUTO_TEST_CASE(contact_forces_move_the_fluid) {
  for (const SteppingMethod method : {euler, heun}) {
    const auto moved = [&](bool pulled_apart) {
      const Frame end = frames_of(pressed(method, pulled_apart)).back();
      return std::abs(end.tracers[0] - Complex(0.0, 0.4));
    };
    BOOST_TEST(moved(false) < 1e-6);
    BOOST_TEST(moved(true) > 1e-4);
  }
}

// In a container that turns as a whole, Heun's method with contact has order two for tracers.
BOOST_AUTO_TEST_CASE(order_with_contact) {
  const auto error = [](SteppingMethod method, double dt) {
    Scene scene = in_container(3.0, {body_at(Circle{0.5}, 1.0, automatic_nodes)}, 0.05);
    scene.walls[0].motion = RotatingWall{1.0};
    scene.tracers = {{-1.0, 0.5}};
    scene.solver.tolerance = 1e-8;
    const Frame end = frames_of(over(scene, 0.8, dt, method)).back();
    return std::abs(end.tracers[0] - scene.tracers[0] * std::polar(1.0, 0.8));
  };
  BOOST_TEST(std::abs(std::log2(error(heun, 0.1) / error(heun, 0.05)) - 2.0) < 0.15);
  BOOST_TEST(std::abs(std::log2(error(euler, 0.1) / error(euler, 0.05)) - 1.0) < 0.15);
}

BOOST_AUTO_TEST_CASE(runs_with_tracers_resume_bit_for_bit) {
  for (const SteppingMethod method : {adams_bashforth2, rk4, dormand_prince54}) {
    check_resumes(pair_with_tracers(method));
  }
  Scene contact = head_on(0.3);
  contact.tracers = {{0.0, 0.9}, {0.2, -1.5}};
  contact.solver.tolerance = 1e-3;
  check_resumes(over(contact, 0.06, 0.02, heun));
}

// Bodies do not feel tracers.
BOOST_AUTO_TEST_CASE(bodies_move_as_without_tracers) {
  const Scene with = pair_with_tracers(rk4);
  Scene without = with;
  without.tracers.clear();
  const Frame a = frames_of(with).back(), b = frames_of(without).back();
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST((a.bodies[k].position == b.bodies[k].position));
    BOOST_TEST((a.bodies[k].omega == b.bodies[k].omega));
  }
  BOOST_TEST(b.tracers.empty());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
