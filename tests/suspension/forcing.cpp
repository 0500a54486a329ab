// Tests the forcing of an instant against closed forms: amplitudes in time, weight and buoyancy,
// traps, magnetic torques, and repulsion.

#include "suspension/bodies/forcing.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "support/eccentric_annulus.hpp"
#include "suspension/motion/describe.hpp"
#include "suspension/scenes.hpp"
#include "suspension/solver/rheology.hpp"

namespace stokesbook::test {

namespace {

using std::numbers::pi;

Scene with_repulsion(std::vector<Body> bodies, std::vector<Wall> walls = {}) {
  Scene repelled = scene(std::move(bodies), {}, std::move(walls));
  repelled.repulsion = Repulsion{3.0, 0.2};
  return repelled;
}

std::vector<Load> loads_at_start(const Scene& scene) {
  return SuspensionSolver(scene).start().forcing.loads;
}

std::string plan_of(const Scene& scene) {
  std::string text;
  for (const std::string& line : describe(SuspensionSolver(scene))) text += line + '\n';
  return text;
}

bool mentions(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(forcing)

// The step that begins at a jump has the value after the jump, and the step that ends there the
// value before the jump.
BOOST_AUTO_TEST_CASE(amplitudes) {
  Scene sheared = scene({body(Circle{1.0}, 16, 0.0)}, ShearFlow{1.0});
  const auto flow = [&](double t, double begin) {
    return SuspensionSolver(sheared).instant({{}}, {t, begin}).forcing.flow;
  };
  BOOST_TEST(flow(3.0, 3.0) == 1.0);
  sheared.flow_amplitude = SteppedAmplitude{{0.0, 1.0, 2.0}, {2.0, -3.0, 0.5}};
  BOOST_TEST(flow(0.0, 0.0) == 2.0);
  BOOST_TEST(flow(1.0, 0.5) == 2.0);
  BOOST_TEST(flow(1.0, 1.0) == -3.0);
  BOOST_TEST(flow(9.0, 9.0) == 0.5);
  sheared.flow_amplitude = RampedAmplitude{{1.0, 2.0, 4.0}, {2.0, -3.0, 1.0}};
  BOOST_TEST(flow(0.0, 0.0) == 2.0);
  BOOST_TEST(flow(1.5, 1.0) == -0.5);
  BOOST_TEST(flow(2.0, 1.0) == -3.0);
  BOOST_TEST(flow(3.5, 2.0) == 0.0);
  BOOST_TEST(flow(9.0, 9.0) == 1.0);
  sheared.flow_amplitude = OscillatingAmplitude{1.0, 2.0, 0.5, 0.3};
  BOOST_TEST(flow(0.2, 0.0) == 1.0 + 2.0 * std::cos(0.8 * pi + 0.3),
             boost::test_tools::tolerance(1e-14));
  sheared.reverse_at = {1.0};
  BOOST_TEST(flow(1.0, 0.9) == 1.0 + 2.0 * std::cos(0.3), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(flow(1.0, 1.0) == -1.0 - 2.0 * std::cos(0.3), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(events_are_jumps_kinks_and_reversals) {
  Scene driven = scene({body(Circle{1.0}, 16, 0.0)}, ShearFlow{1.0});
  driven.reverse_at = {0.5, 3.0};
  driven.flow_amplitude = SteppedAmplitude{{0.0, 1.0}, {1.0, 2.0}};
  driven.bodies[0].loads.amplitude = RampedAmplitude{{0.0, 3.0, 4.0}, {1.0, 2.0, 3.0}};
  driven.gravity = Gravity{1.0, 1.0, OscillatingAmplitude{0.0, 1.0, 7.0, 0.0}};
  BOOST_TEST((forcing_events(driven) == std::vector{0.5, 1.0, 3.0, 4.0}));
  BOOST_TEST(shortest_period(driven) == 7.0);
  driven.magnetic_field = MagneticField{1.0, -0.25, {}};
  BOOST_TEST(shortest_period(driven) == 4.0);
}

BOOST_AUTO_TEST_CASE(an_instant_without_forcing_is_refused) {
  const SuspensionSolver solver(scene({body(Circle{1.0}, 16, 0.0)}, ShearFlow{1.0}));
  BOOST_CHECK_THROW(solver.solve({solver.start().configuration, {}}), std::invalid_argument);
}

// A disk sinks near the wall of a round container: its motion is that at which the closed form for
// two eccentric circles gives the weight as the load, and no torque.
BOOST_AUTO_TEST_CASE(a_buoyant_disk_near_a_wall) {
  for (const double density : {1.5, 0.2}) {
    Scene settling = scene({body(Circle{0.5}, 0, {1.2, 0.4})}, {}, {outer_wall(Circle{2.0}, 0)});
    settling.viscosity = 0.7;
    settling.solver.tolerance = 1e-10;
    settling.gravity = Gravity{{0.3, -2.0}, 0.8, {}};
    settling.bodies[0].loads.density = density;
    const Solved solved(settling);
    const Complex weight = (density - 0.8) * 0.25 * pi * Complex{0.3, -2.0};
    const Load load = inner_load({0.5, 2.0, {1.2, 0.4}, 0.0, solved.motion(0), {}}, 0.7);
    BOOST_TEST(std::abs(load.force - weight) < 1e-8 * std::abs(weight));
    BOOST_TEST(std::abs(load.torque) < 1e-8 * std::abs(weight));
  }
}

// The area of the curve r(t) is int r^2 / 2 dt, and its first moment int r^3 e^{it} / 3 dt.
BOOST_AUTO_TEST_CASE(weight_acts_at_the_centroid_of_the_area) {
  Scene settling = scene({body(lopsided_curve(), 64, {3.0, 1.0}, 0.6)});
  settling.gauge_length = 100.0;
  settling.gravity = Gravity{{0.5, -1.0}, 1.0, {}};
  settling.bodies[0].loads.density = 3.0;
  double area = 0.0;
  Complex moment{};
  constexpr int points = 400;
  for (int k = 0; k < points; ++k) {
    const double t = 2.0 * pi * k / points;
    const double r = 1.0 + 0.2 * std::cos(2.0 * t) + 0.15 * std::cos(3.0 * t + 1.0);
    area += r * r / 2.0 * (2.0 * pi / points);
    moment += std::polar(r * r * r / 3.0 * (2.0 * pi / points), t + 0.6);
  }
  const Complex force = 2.0 * area * Complex{0.5, -1.0};
  const Load load = loads_at_start(settling)[0];
  BOOST_TEST(std::abs(load.force - force) < 1e-13);
  BOOST_TEST(std::abs(load.torque - cross(moment / area, force)) < 1e-13);
  BOOST_TEST(std::abs(load.torque) > 0.02);
}

BOOST_AUTO_TEST_CASE(traps_and_magnetic_torques) {
  Scene driven =
      scene({body(Ellipse{2.0, 1.0}, 32, {1.0, 2.0}, 0.5), held_body(Circle{1.0}, 16, 9.0)});
  driven.magnetic_field = MagneticField{2.0, 0.25, RampedAmplitude{{0.0, 2.0}, {0.0, 1.0}}};
  driven.bodies[0].loads = {{}, {}, Trap{3.0, Complex{0.0, 5.0}}, {0.0, 4.0}};
  const SuspensionSolver solver(driven);
  const Configuration moved{{{2.0, 3.0}, 0.7}, {9.0, 0.0}};
  const std::vector<Load> loads = solver.instant(moved, {1.5, 0.0}).forcing.loads;
  BOOST_TEST(std::abs(loads[0].force - 3.0 * Complex{-2.0, 2.0}) < 1e-14);
  // The field has turned by 3 pi / 4, and the moment points to pi / 2 + 0.7.
  BOOST_TEST(loads[0].torque == 4.0 * 1.5 * std::sin(0.75 * pi - 0.5 * pi - 0.7),
             boost::test_tools::tolerance(1e-13));
  BOOST_TEST(std::abs(loads[1].force) == 0.0);
  driven.bodies[0].loads.trap->centre.reset();
  const Load back = SuspensionSolver(driven).instant(moved, {}).forcing.loads[0];
  BOOST_TEST(std::abs(back.force - 3.0 * Complex{-1.0, -1.0}) < 1e-14);
}

// Disks of radius 1 at the gap 0.3 from each other and 0.5 from a wall.
BOOST_AUTO_TEST_CASE(repulsion_falls_off_with_the_gap) {
  const double pair = 3.0 * std::exp(-0.3 / 0.2), wall = 3.0 * std::exp(-0.5 / 0.2);
  const auto loads =
      loads_at_start(with_repulsion({body(Circle{1.0}, 64, -2.15), body(Circle{1.0}, 64, 0.15)},
                                    {outer_wall(Circle{3.65}, 128)}));
  BOOST_TEST(std::abs(loads[0].force - (wall - pair)) < 1e-13);
  const double far = 3.0 * std::exp(-2.5 / 0.2);
  BOOST_TEST(std::abs(loads[1].force - (pair - far)) < 1e-13);
  BOOST_TEST(std::abs(loads[0].torque) < 1e-15);
  const auto beyond =
      loads_at_start(with_repulsion({body(Circle{1.0}, 16, -6.0), body(Circle{1.0}, 16, 6.0)}));
  BOOST_TEST(beyond[0].force == 0.0);
}

// Forces are exactly opposite; torques about the origin cancel up to rounding.
BOOST_AUTO_TEST_CASE(repulsion_obeys_the_third_law) {
  const Scene crowd = with_repulsion({body(Ellipse{2.0, 0.5}, 64, {-1.0, 0.9}, 0.3),
                                      body(lopsided_curve(), 64, {1.6, -1.0}, 2.0)});
  const auto loads = loads_at_start(crowd);
  BOOST_TEST(loads[0].force == -loads[1].force);
  BOOST_TEST(std::abs(loads[0].force) > 1e-3);
  const double torque = loads[0].torque + loads[1].torque +
                        cross(crowd.bodies[0].position, loads[0].force) +
                        cross(crowd.bodies[1].position, loads[1].force);
  BOOST_TEST(std::abs(loads[0].torque) > 1e-3);
  BOOST_TEST(std::abs(torque) < 1e-15);
}

// The sum of the forces of three bodies on each other is rounding, which the check of the net force
// in an unbounded fluid accepts.
BOOST_AUTO_TEST_CASE(repulsion_has_no_net_force) {
  Scene three = with_repulsion({body(Circle{1.0}, 0, 0.0), body(Circle{0.7}, 0, {1.8, 0.3}),
                                body(Circle{0.5}, 0, {0.9, 1.5})});
  three.solver.tolerance = 1e-6;
  const Solved solved(three);
  BOOST_TEST(std::abs(solved.motion(0).velocity) > 1e-3);
}

// A Couette cell measures the same viscosity at each moment of an oscillation, except where the
// walls rest, and none if the walls' rates have no constant ratio.
BOOST_AUTO_TEST_CASE(torque_ratio_of_an_oscillating_cell) {
  Scene cell = scene({body(Circle{0.4}, 48, 2.0)}, {},
                     {outer_wall(Circle{3.0}, 96, RotatingWall{1.0}), inner_wall(Circle{1.0}, 64)});
  cell.solver.tolerance = 1e-8;
  cell.walls[0].amplitude = OscillatingAmplitude{0.0, 1.0, 8.0, -pi / 2};
  const SuspensionSolver solver(cell);
  const Rheometer measure(solver);
  const Configuration start = solver.start().configuration;
  const auto ratio = [&](double t) {
    return measure(solver.solve(solver.instant(start, {t, 0.0}))).torque_ratio;
  };
  BOOST_TEST(std::abs(ratio(1.0) - 1.03207638279558) < 1e-7);
  BOOST_TEST(std::abs(ratio(5.0) - 1.03207638279558) < 1e-7);
  cell.walls[1].motion = RotatingWall{0.5};
  BOOST_TEST(!is_couette_cell(cell));
  cell.walls[1].amplitude = cell.walls[0].amplitude;
  BOOST_TEST(is_couette_cell(cell));
  cell.walls[0].amplitude = cell.walls[1].amplitude = SteppedAmplitude{{0.0}, {0.0}};
  const SuspensionSolver at_rest(cell);
  BOOST_TEST(std::isnan(Rheometer(at_rest)(at_rest.solve(at_rest.start())).torque_ratio));
}

BOOST_AUTO_TEST_CASE(the_plan_tells_what_a_scene_asks_for) {
  Scene driven = scene({body(Circle{1.0}, 16, 0.0)}, ShearFlow{1.0});
  const std::string plain = plan_of(driven);
  BOOST_TEST(!mentions(plain, "loads  "));
  BOOST_TEST(!mentions(plain, "amplitudes"));
  driven.flow_amplitude = OscillatingAmplitude{.period = 2.5};
  driven.bodies[0].loads.trap = Trap{1.0, {}};
  driven.bodies[0].loads.amplitude = RampedAmplitude{{1.0, 2.0}, {0.0, 1.0}};
  driven.repulsion = Repulsion{2.0, 0.5};
  driven.reverse_at = {3.0};  // no amplitude
  const std::string plan = plan_of(driven);
  BOOST_TEST(mentions(plan, "given Stokeslets"));
  BOOST_TEST(mentions(plan, "traps, repulsion 2 exp(-gap / 0.5)"));
  BOOST_TEST(mentions(plan, "steps end at 2 times"));
  BOOST_TEST(mentions(plan, "shortest period 2.5"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
