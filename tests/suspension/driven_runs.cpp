// Tests runs whose forcing depends on time and place against closed forms: relaxation in a trap,
// Jeffery orbits in oscillating shear, magnetic torques, two disks that repel each other; the
// orders of the steppers across jumps and kinks; and contact under these loads.

#include <cmath>
#include <functional>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "support/known_motions.hpp"
#include "suspension/driven.hpp"

namespace stokesbook::test {

namespace {

using std::numbers::pi;
using enum SteppingMethod;

// A piece of an amplitude on which it is linear.
struct Piece {
  double begin, value, slope;
};

// Returns x(t) for x' = gain A(t) - rate x with a piecewise linear A.
double relaxed(double x, double rate, double gain, const std::vector<Piece>& pieces, double t) {
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece& piece = pieces[k];
    const double end = k + 1 < pieces.size() ? pieces[k + 1].begin : t;
    const auto particular = [&](double s) {
      return gain / rate * (piece.value + piece.slope * (s - piece.begin) - piece.slope / rate);
    };
    x = particular(end) + (x - particular(piece.begin)) * std::exp(-rate * (end - piece.begin));
  }
  return x;
}

struct DrivenDisk {
  Amplitude amplitude;
  std::function<double(double)> exact;  // x(1) from x(0)
};

constexpr double stiffness = 4.0, force = 3.0;

std::vector<DrivenDisk> driven_disks() {
  const double rate = disk_mobility * stiffness, gain = disk_mobility * force;
  const std::vector<Piece> steps{{0.0, 2.0, 0.0}, {0.37, -1.0, 0.0}, {0.81, 1.0, 0.0}};
  const std::vector<Piece> ramp{
      {0.0, 2.0, -3.0 / 0.37}, {0.37, -1.0, 2.0 / 0.44}, {0.81, 1.0, 0.0}};
  const double omega = 2.0 * pi / 0.7, phase = 2.0;
  const auto particular = [=](double t) {
    const double angle = omega * t + phase;
    return gain * (0.2 / rate + 2.0 * (rate * std::cos(angle) + omega * std::sin(angle)) /
                                    (rate * rate + omega * omega));
  };
  return {{SteppedAmplitude{{0.0, 0.37, 0.81}, {2.0, -1.0, 1.0}},
           [=](double x) { return relaxed(x, rate, gain, steps, 1.0); }},
          {RampedAmplitude{{0.0, 0.37, 0.81}, {2.0, -1.0, 1.0}},
           [=](double x) { return relaxed(x, rate, gain, ramp, 1.0); }},
          {OscillatingAmplitude{0.2, 2.0, 0.7, 2.0},
           [=](double x) { return particular(1.0) + (x - particular(0.0)) * std::exp(-rate); }}};
}

double error_of(const DrivenDisk& driven, SteppingMethod method, double dt) {
  Scene scene = disk_scene(method, 1.0, dt);
  scene.bodies[0].force = force;
  scene.bodies[0].loads.amplitude = driven.amplitude;
  scene.bodies[0].loads.trap = Trap{stiffness, Complex{}};
  return std::abs(frames_of(scene).back().bodies[0].position.real() - driven.exact(2.0));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(driven_runs)

BOOST_AUTO_TEST_CASE(a_disk_relaxes_in_a_trap) {
  Scene scene = disk_scene(dormand_prince54, 3.0, 0.1);
  scene.output.dt_write = 0.5;
  const Complex centre{-1.0, 3.0}, start = scene.bodies[0].position;
  scene.bodies[0].loads.trap = Trap{stiffness, centre};
  for (const Frame& frame : frames_of(scene)) {
    const Complex exact =
        centre + (start - centre) * std::exp(-disk_mobility * stiffness * frame.t);
    BOOST_TEST(std::abs(frame.bodies[0].position - exact) < 1e-8);
    BOOST_TEST(std::abs(frame.bodies[0].force - stiffness * (centre - exact)) < 1e-7);
  }
}

// The steps end at the jumps and kinks at 0.37 and 0.81, so that no method loses its order there.
// The lengths of steps between these times are equal, and are divided by 8 up to a few per cent.
BOOST_AUTO_TEST_CASE(steppers_keep_their_orders_at_jumps_and_kinks) {
  for (const DrivenDisk& driven : driven_disks()) {
    for (const auto& [method, dt, order] : {std::tuple{euler, 0.02, 1.0},
                                            {adams_bashforth2, 0.04, 2.0},
                                            {heun, 0.08, 2.0},
                                            {rk4, 0.1, 4.0}}) {
      const double measured =
          std::log(error_of(driven, method, dt) / error_of(driven, method, dt / 8.0)) /
          std::log(8.0);
      BOOST_TEST(std::abs(measured / order - 1.0) < 0.08,
                 "amplitude " << driven.amplitude.index() << ", method " << static_cast<int>(method)
                              << ": order " << measured << ", expected " << order);
    }
    for (const SteppingMethod method : {bogacki_shampine32, dormand_prince54, prince_dormand87}) {
      BOOST_TEST(error_of(driven, method, 0.1) < 1e-8);
    }
  }
}

// Steps that are adapted to the error are at most a quarter of a period, however slow the start.
BOOST_AUTO_TEST_CASE(adapted_steps_resolve_an_oscillation) {
  Scene scene = disk_scene(dormand_prince54, 20.0, 0.1);
  scene.time->dt.reset();
  scene.bodies[0].force = 1e-6;
  scene.bodies[0].loads.amplitude = OscillatingAmplitude{.period = 2.0, .phase = -pi / 2};
  for (const StepInfo& step : recorded_run(scene).steps) BOOST_TEST(step.dt <= 0.5 * (1.0 + 1e-12));
}

// The angle of Jeffery's orbit depends on the strain alone, which is the integral of the rate.
BOOST_AUTO_TEST_CASE(jeffery_orbits_in_shear_that_changes) {
  const auto error = [](const Amplitude& amplitude, double strain) {
    Scene scene;
    scene.flow = ShearFlow{2.0};
    scene.flow_amplitude = amplitude;
    scene.bodies = {body_at(Ellipse{3.0, 1.0}, {0.4, -0.2}, 48)};
    scene.solver.tolerance = 1e-9;
    scene.time = TimeSettings{.t_final = 3.0, .tolerance = 1e-8};
    scene.output.dt_write = 3.0;
    const BodyState end = frames_of(scene).back().bodies[0];
    return std::abs(end.orientation - jeffery_angle(3.0, 2.0 * strain));
  };
  const double period = 1.7, phase = 0.6, omega = 2.0 * pi / period;
  BOOST_TEST(error(OscillatingAmplitude{0.3, 1.5, period, phase},
                   0.9 + 1.5 / omega * (std::sin(omega * 3.0 + phase) - std::sin(phase))) < 1e-7);
  BOOST_TEST(error(SteppedAmplitude{{0.0, 1.1, 2.3}, {1.0, -0.5, 2.0}}, 1.1 - 0.6 + 1.4) < 1e-7);
  BOOST_TEST(error(RampedAmplitude{{0.0, 1.0, 2.5}, {0.0, 2.0, 1.0}}, 1.0 + 2.25 + 0.5) < 1e-7);
}

// Walls, and the disk between them, turn by the integral of the amplitude.
BOOST_AUTO_TEST_CASE(walls_and_held_bodies_move_by_the_integral_of_their_amplitude) {
  Scene scene;
  scene.walls = {{WallRole::outer,
                  Circle{4.0},
                  {},
                  0.0,
                  64,
                  RotatingWall{0.5},
                  SteppedAmplitude{{0.0, 0.9}, {2.0, -1.0}}}};
  scene.bodies = {body_at(Circle{1.0}, 0.0, 32)};
  scene.time = TimeSettings{2.0, 0.25, heun};
  const Frame turned = frames_of(scene).back();
  BOOST_TEST(turned.walls[0].orientation == 0.5 * (1.8 - 1.1), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(turned.bodies[0].orientation - 0.5 * (1.8 - 1.1)) < 1e-7);
  scene.walls[0] = {WallRole::outer, Circle{4.0}, {}, 0.0, 64};
  scene.bodies[0].held = true;
  scene.bodies[0].velocity = {0.5, 0.0};
  scene.bodies[0].loads.amplitude = RampedAmplitude{{0.0, 1.3}, {0.0, 1.0}};
  const Frame moved = frames_of(scene).back();
  BOOST_TEST(std::abs(moved.bodies[0].position - 0.5 * (0.65 + 0.7)) < 1e-12);
}

// In a fixed field at the angle 0, tan(theta / 2) decays at the rate m B / (4 pi). A field that
// turns slowly enough takes the disk along at the angle whose torque balances the drag.
BOOST_AUTO_TEST_CASE(a_magnetic_disk_turns_into_the_field_and_with_it) {
  Scene scene = disk_scene(dormand_prince54, 4.0, 0.1);
  scene.bodies[0].loads.magnetic_moment = 5.0;
  scene.bodies[0].orientation = 2.5;
  scene.magnetic_field = MagneticField{2.0, 0.0, {}};
  const double rate = 10.0 / (4.0 * pi);
  BOOST_TEST(std::abs(frames_of(scene).back().bodies[0].orientation -
                      2.0 * std::atan(std::tan(1.25) * std::exp(-4.0 * rate))) < 1e-8);
  scene.magnetic_field->frequency = 0.1;
  const double lag = std::asin(0.2 * pi / rate);
  scene.bodies[0].orientation = -lag;
  BOOST_TEST(std::abs(frames_of(scene).back().bodies[0].orientation - (0.8 * pi - lag)) < 1e-8);
}

// Two unit disks whose centres are 2 cosh(alpha) apart part under the forces F and -F at the
// speed F / (2 pi) (alpha - tanh(2 alpha) / 2).
BOOST_AUTO_TEST_CASE(a_soft_pair_parts_as_in_the_closed_form) {
  Scene scene;
  scene.bodies = {body_at(Circle{1.0}, -1.1, 96), body_at(Circle{1.0}, 1.1, 96)};
  scene.repulsion = Repulsion{8.0, 0.5};
  scene.solver.tolerance = 1e-9;
  scene.time = TimeSettings{.t_final = 2.0, .tolerance = 1e-8};
  scene.output.dt_write = 2.0;
  const auto speed = [](double distance) {
    const double alpha = std::acosh(0.5 * distance);
    return 8.0 * std::exp(-(distance - 2.0) / 0.5) / (2.0 * pi) *
           (alpha - 0.5 * std::tanh(2.0 * alpha));
  };
  double distance = 2.2;
  constexpr int steps = 2000;
  for (int k = 0; k < steps; ++k) {  // the midpoint rule, with an error of about 1e-8
    constexpr double dt = 2.0 / steps;
    distance += dt * speed(distance + 0.5 * dt * speed(distance));
  }
  const std::vector<Frame> frames = frames_of(scene);
  const Complex found = frames.back().bodies[1].position - frames.back().bodies[0].position;
  BOOST_TEST(std::abs(found - distance) < 1e-6);
  BOOST_TEST(distance > 2.35);
}

// Traps press disks together until contact forces balance the traps at the least gap.
BOOST_AUTO_TEST_CASE(contact_balances_traps) {
  for (const SteppingMethod method : {euler, heun}) {
    Scene scene = pressed_pair(method);
    scene.bodies[0].loads.trap = Trap{5.0, Complex{0.3, 0.0}};
    scene.bodies[1].loads.trap = Trap{5.0, Complex{-0.3, 0.0}};
    const Frame end = frames_of(scene).back();
    const Complex apart = end.bodies[1].position - end.bodies[0].position;
    BOOST_TEST(std::abs(std::abs(apart) - 2.1) < 1e-3);
    BOOST_REQUIRE(end.contacts.size() == 1u);
    BOOST_TEST(std::abs(end.contacts[0].force - 5.0 * (1.05 + 0.3)) < 0.05);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
