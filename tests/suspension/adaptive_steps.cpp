// Tests methods with adaptive steps (chapter 09): they reach the tolerance, and not a much smaller
// error, on a Jeffery orbit and on two circles that pass each other. Where the flow contracts,
// errors decay.

#include <algorithm>
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "support/known_motions.hpp"
#include "suspension/motion/stepping.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

Scene adapted(Scene scene, SteppingMethod method, double tolerance) {
  scene.solver.tolerance = std::max(1e-12, 0.01 * tolerance);
  scene.time->method = method;
  scene.time->tolerance = tolerance;
  return scene;
}

Scene jeffery() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {body_at(Ellipse{3.0, 1.0}, {0.4, -0.2}, 48)};
  scene.time = TimeSettings{20.0};
  return scene;
}

Scene passing_circles() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {body_at(Circle{1.0}, {-4.0, 0.75}, automatic_nodes),
                  body_at(Circle{1.0}, {4.0, -0.75}, automatic_nodes)};
  scene.time = TimeSettings{12.0};
  scene.output.dt_write = 4.0;
  return scene;
}

// Returns the largest error of the angle at the ends of all steps.
double jeffery_error(SteppingMethod method, double tolerance) {
  double error = 0.0;
  for (const Frame& frame : frames_of(adapted(jeffery(), method, tolerance))) {
    error = std::max(error, std::abs(frame.bodies[0].orientation - jeffery_angle(3.0, frame.t)));
  }
  return error;
}

// Returns the largest difference of positions and angles of bodies of radius 1.
double difference(const std::vector<Frame>& frames, const std::vector<Frame>& others) {
  double largest = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    BOOST_REQUIRE_EQUAL(frames[i].t, others[i].t);
    for (std::size_t k = 0; k < frames[i].bodies.size(); ++k) {
      const BodyState &a = frames[i].bodies[k], &b = others[i].bodies[k];
      const Complex distance = a.position - b.position;
      largest = std::max({largest, std::abs(distance.real()), std::abs(distance.imag()),
                          std::abs(a.orientation - b.orientation)});
    }
  }
  return largest;
}

void check_error(double error, SteppingMethod method, double tolerance) {
  BOOST_TEST_CONTEXT("method " << static_cast<int>(method) << ", tolerance " << tolerance) {
    BOOST_TEST(error < 10.0 * tolerance);
    // The error estimate of the pair of the highest order is pessimistic.
    BOOST_TEST(error > (method == prince_dormand87 ? 0.02 : 0.1) * tolerance);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_jeffery_orbit_is_as_accurate_as_asked) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    check_error(jeffery_error(bogacki_shampine32, tolerance), bogacki_shampine32, tolerance);
  }
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    check_error(jeffery_error(dormand_prince54, tolerance), dormand_prince54, tolerance);
  }
  for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    check_error(jeffery_error(prince_dormand87, tolerance), prince_dormand87, tolerance);
  }
}

BOOST_AUTO_TEST_CASE(circles_that_pass_each_other_are_as_accurate_as_asked) {
  const std::vector<Frame> exact = frames_of(adapted(passing_circles(), prince_dormand87, 1e-12));
  const BodyState& body = exact.back().bodies[0];
  BOOST_TEST(std::abs(body.position - Complex(5.05560884029, 0.73856191218)) < 2e-11);
  BOOST_TEST(std::abs(body.orientation + 5.92487175825) < 2e-11);
  const auto check = [&](SteppingMethod method, double tolerance) {
    const auto frames = frames_of(adapted(passing_circles(), method, tolerance));
    check_error(difference(frames, exact), method, tolerance);
  };
  for (const double tolerance : {1e-3, 1e-5, 1e-6}) check(bogacki_shampine32, tolerance);
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8, 1e-10}) check(dormand_prince54, tolerance);
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) check(prince_dormand87, tolerance);
}

BOOST_AUTO_TEST_CASE(circles_that_approach_each_other_are_better_than_asked) {
  // The flow contracts: D' = O(gap), so D(t) forgets early errors.
  for (const SteppingMethod method : {bogacki_shampine32, dormand_prince54, prince_dormand87}) {
    Scene scene;
    scene.flow = ExtensionalFlow{-1.0};
    scene.bodies = {body_at(Circle{1.0}, -2.0, automatic_nodes),
                    body_at(Circle{1.0}, 2.0, automatic_nodes)};
    scene.time = TimeSettings{2.0};
    const std::vector<Frame> frames = frames_of(adapted(scene, method, 1e-6));
    for (const Frame& frame : frames) {
      const double distance = (frame.bodies[1].position - frame.bodies[0].position).real();
      BOOST_TEST(std::abs(distance - circle_distance(4.0, frame.t)) < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_least_step_is_a_millionth_of_the_longest_that_may_be) {
  const auto least = [](TimeSettings time) {
    Scene scene;
    scene.bodies = {body_at(Circle{1.0}, 0.0, 32)};
    scene.time = time;
    const SuspensionSolver solver(scene);
    return stepping_settings(solver, to_state(solver.start().configuration).size()).dt_min;
  };
  TimeSettings time{1e6, 0.1, dormand_prince54};
  time.dt_max = 0.5;
  BOOST_TEST(least(time) == 1e-7, boost::test_tools::tolerance(1e-15));
  time.dt.reset();
  BOOST_TEST(least(time) == 5e-7, boost::test_tools::tolerance(1e-15));
  time.dt_max.reset();
  BOOST_TEST(least(time) == 1.0, boost::test_tools::tolerance(1e-15));
  time.dt_min = 0.25;
  BOOST_TEST(least(time) == 0.25);
  BOOST_TEST(least({1e6, 0.1}) == 1e-7, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(units_of_length_and_time_do_not_matter) {
  // Lengths are in millimetres and times in minutes instead of metres and seconds, approximated by
  // powers of two.
  const auto ends_of = [](double length, double time) {
    Scene scene = passing_circles();
    scene.flow = ShearFlow{1.0 / time};
    for (Body& body : scene.bodies) {
      body.shape = Circle{length};
      body.position *= length;
    }
    scene.time = TimeSettings{6.0 * time, {}, dormand_prince54, 1e-4};
    scene.output.dt_write.reset();
    std::vector<double> ends;
    for (const Frame& frame : frames_of(scene)) ends.push_back(frame.t / time);
    return ends;
  };
  const std::vector<double> ends = ends_of(1.0, 1.0), others = ends_of(1024.0, 1.0 / 64.0);
  BOOST_TEST(ends == others, boost::test_tools::tolerance(1e-6)
                                 << boost::test_tools::per_element());
}

}  // namespace stokesbook::test
