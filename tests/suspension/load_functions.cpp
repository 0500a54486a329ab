// Tests loads that a function gives: they replace loads of the scene bit for bit, with contact and
// by all steppers; they see motions; and runs under them are resumed bit for bit.

#include <cmath>
#include <optional>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "suspension/driven.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

bool same(const Frame& a, const Frame& b) {
  bool equal = a.t == b.t;
  for (std::size_t k = 0; k < a.bodies.size(); ++k) {
    equal = equal && a.bodies[k].position == b.bodies[k].position &&
            a.bodies[k].orientation == b.bodies[k].orientation &&
            a.bodies[k].velocity == b.bodies[k].velocity &&
            a.bodies[k].force == b.bodies[k].force && a.bodies[k].torque == b.bodies[k].torque;
  }
  return equal;
}

// Runs a scene under additional loads, from a checkpoint if there is one.
std::vector<Frame> run(const SuspensionSolver& solver, const LoadFunction& loads,
                       std::vector<Checkpoint>* checkpoints = nullptr,
                       const std::optional<Checkpoint>& from = {}) {
  std::vector<Frame> frames;
  Observer observer;
  observer.frame = [&](const Frame& frame) { frames.push_back(frame); };
  if (checkpoints) {
    observer.checkpoint = [=](const Checkpoint& reached) { checkpoints->push_back(reached); };
  }
  Simulation simulation(solver, observer, loads);
  if (from) simulation.resume(*from);
  simulation.run();
  return frames;
}

// Returns a trap for each body, as a load function.
LoadFunction traps(double spring, const std::vector<Complex>& centres) {
  return [=](double, const Configuration& configuration, const std::vector<RigidMotion>&) {
    std::vector<Load> loads;
    for (std::size_t k = 0; k < centres.size(); ++k) {
      loads.push_back({spring * (centres[k] - configuration[k].position), 0.0});
    }
    return loads;
  };
}

}  // namespace

BOOST_AUTO_TEST_SUITE(load_functions)

// Contact forces do not see how a load came about: a load function gives the frames of a trap of
// the scene bit for bit, by all methods.
BOOST_AUTO_TEST_CASE(load_functions_replace_laws_of_the_scene) {
  const std::vector<Complex> centres{{0.3, 0.2}, {-0.3, 0.0}};
  std::vector<Scene> scenes{pressed_pair(euler), pressed_pair(heun)};
  for (const SteppingMethod method : {euler, adams_bashforth2, heun, rk4, dormand_prince54}) {
    Scene scene = over(pressed_pair(method), 0.5, 0.1, method);
    scene.contact.reset();
    scene.bodies[1].position += 2.0;
    scenes.push_back(scene);
  }
  for (Scene& scene : scenes) {
    scene.time->t_final = 0.5;
    const std::vector<Frame> by_function = run(SuspensionSolver(scene), traps(5.0, centres));
    for (std::size_t k = 0; k < 2; ++k) scene.bodies[k].loads.trap = Trap{5.0, centres[k]};
    const std::vector<Frame> by_law = frames_of(scene);
    BOOST_REQUIRE(by_function.size() == by_law.size());
    for (std::size_t k = 0; k < by_law.size(); ++k) BOOST_TEST(same(by_function[k], by_law[k]));
  }
}

// The load -zeta U, from the velocity U of the solve before, converges to the velocity
// M F / (1 + zeta M).
BOOST_AUTO_TEST_CASE(load_functions_see_the_motions_of_the_solve_before) {
  Scene scene = disk_scene(euler, 3.0, 0.1);
  scene.bodies[0].force = 2.0;
  int first = 0;
  const LoadFunction drag = [&](double, const Configuration&,
                                const std::vector<RigidMotion>& motions) -> std::vector<Load> {
    first += motions.empty() ? 1 : 0;
    return {{motions.empty() ? 0.0 : -0.7 * motions[0].velocity, 0.0}};
  };
  const std::vector<Frame> frames = run(SuspensionSolver(scene), drag);
  BOOST_TEST(first == 1);
  BOOST_TEST(std::abs(frames.back().bodies[0].velocity -
                      2.0 * disk_mobility / (1.0 + 0.7 * disk_mobility)) < 1e-9);
  const LoadFunction none = [](double, const Configuration&, const std::vector<RigidMotion>&) {
    return std::vector<Load>{};
  };
  BOOST_CHECK_THROW(run(SuspensionSolver(scene), none), std::invalid_argument);
}

// Everything that depends on time, place and motions, with events at and between written times.
BOOST_AUTO_TEST_CASE(driven_runs_resumed_at_any_frame_continue_bit_for_bit) {
  for (const SteppingMethod method :
       {euler, adams_bashforth2, heun, rk4, bogacki_shampine32, dormand_prince54}) {
    Scene scene;
    scene.flow = ShearFlow{1.0};
    scene.flow_amplitude = OscillatingAmplitude{0.5, 1.0, 0.7, 0.2};
    scene.gauge_length = gauge;
    scene.bodies = {body_at(Ellipse{1.0, 0.6}, {-1.4, 0.5}, 32),
                    body_at(Circle{0.8}, {1.3, -0.4}, 32)};
    scene.bodies[0].force = {0.3, 1.0};
    scene.bodies[0].loads = {SteppedAmplitude{{0.0, 0.25}, {1.0, -2.0}}, {}, {}, {1.0, 0.5}};
    scene.bodies[1].loads = {RampedAmplitude{{0.0, 0.6}, {0.0, 1.0}}, 3.0, Trap{2.0, {}}, {}};
    scene.gravity = Gravity{{0.0, -1.0}, 1.0, {}};
    scene.magnetic_field = MagneticField{1.0, 0.5, {}};
    scene.repulsion = Repulsion{1.0, 0.3};
    scene.reverse_at = {0.4};
    scene.solver.tolerance = 1e-4;
    scene.time = TimeSettings{1.0, 0.07, method};
    if (method == euler || method == heun) scene.contact = ContactSettings{0.05};
    scene.output.dt_write = 0.25;
    const LoadFunction drag = [](double t, const Configuration& configuration,
                                 const std::vector<RigidMotion>& motions) {
      std::vector<Load> loads{{{t, 0.0}, 0.0}, {0.1 * configuration[0].position, 0.0}};
      if (!motions.empty()) loads[0].force -= 0.1 * motions[0].velocity;
      return loads;
    };
    const SuspensionSolver solver(scene);
    std::vector<Checkpoint> checkpoints;
    const std::vector<Frame> whole = run(solver, drag, &checkpoints);
    BOOST_REQUIRE(whole.size() == 5u);
    for (std::size_t first = 1; first < whole.size(); ++first) {
      const std::vector<Frame> rest = run(solver, drag, nullptr, checkpoints[first - 1]);
      BOOST_REQUIRE(rest.size() + first == whole.size());
      for (std::size_t i = 0; i < rest.size(); ++i) BOOST_TEST(same(rest[i], whole[i + first]));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
