// Tests the densities with which the solves of a step begin (chapter 09, "Better guesses"): stages
// lie off the path of the bodies, and the deviations of earlier stages tell by how much.
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "suspension/motion/instant_solver.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

Scene sheared_ellipses() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {body_at(Ellipse{1.0, 0.6}, {-2.0, 0.5}, 64),
                  body_at(Ellipse{0.8, 0.5}, {1.5, -0.4}, 64)};
  scene.solver.tolerance = 1e-6;
  scene.solver.gmres_tol = 1e-10;
  scene.time = TimeSettings{0.8, 0.05, SteppingMethod::heun};
  scene.output.dt_write = 0.8;
  return scene;
}

// Returns the configuration of a smooth motion.
Configuration path(double t) {
  return {{{-2.0 + 0.3 * t, 0.5 - 0.2 * t * t}, 0.7 * t},
          {{1.5 * std::cos(0.4 * t), std::sin(0.3 * t) - 0.4}, 0.5 - t + 0.2 * t * t}};
}

// Returns the configuration of a stage, which deviates from the path by dt^2.
Configuration off_path(double t, double dt) {
  Configuration stage = path(t);
  stage[0].position += 4.0 * dt * dt * Complex{0.5, 1.0 - t};
  stage[0].orientation -= 4.0 * dt * dt * (0.8 + t);
  stage[1].orientation += 4.0 * dt * dt;
  return stage;
}

// Returns the relative residual with which a solve has begun.
double first_residual(const TimedSolution& timed) {
  return timed.solution.gmres.history.front();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stage_guesses)

BOOST_AUTO_TEST_CASE(deviations_of_stages_are_foreseen_for_steps_of_any_length) {
  const SuspensionSolver solver(sheared_ellipses());
  const OutputSchedule schedule(solver.scene());
  RunStatistics statistics;
  InstantSolver instants(solver, schedule, statistics, {});
  double t = 0.0;
  instants.solve({t, t}, path(t));
  for (const double dt : {0.05, 0.05, 0.05, 0.05, 0.02, 0.02}) {
    const StepTime end{t + dt, t};
    const TimedSolution stage = instants.solve_stage(end, off_path(end.t, dt));
    const TimedSolution there = instants.solve(end, path(end.t));
    // The density of the stage as it is, taken for that at the end.
    const Solution plain = solver.solve_nearby(
        there.solution.instant, {},
        [&](const Discretisation&) -> ComplexVector { return stage.solution.density; });
    const double deviation = plain.gmres.history.front();
    BOOST_TEST_CONTEXT("t = " << t << ", dt = " << dt << ", deviation " << deviation) {
      BOOST_TEST(deviation > dt * dt);
      if (t > 0.12) {
        BOOST_TEST(first_residual(stage) < 0.15 * deviation);
        BOOST_TEST(first_residual(there) < 0.02 * deviation);
      }
    }
    t = end.t;
  }
}

// After a reversal bodies retrace their paths, and steps take no more iterations than before.
BOOST_AUTO_TEST_CASE(deviations_are_mirrored_where_all_forcing_reverses) {
  Scene scene = sheared_ellipses();
  scene.reverse_at = {0.4};
  const SuspensionSolver solver(scene);
  std::vector<StepInfo> steps;
  Observer observer;
  observer.step = [&](const StepInfo& step) { steps.push_back(step); };
  Simulation(solver, observer).run();
  BOOST_REQUIRE(steps.size() == 16U);
  for (std::size_t k = 4; k < 8; ++k) {
    BOOST_TEST_CONTEXT("step " << k) {
      BOOST_TEST(steps[15 - k].gmres_iterations <= steps[k].gmres_iterations + 1);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
