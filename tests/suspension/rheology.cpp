// Tests the rheology (chapter 12) against closed forms and reference numbers of the specification,
// and which quantities are undefined.

#include "suspension/solver/rheology.hpp"

#include "scene/scene.hpp"
#include "suspension/expected.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {
namespace {

using std::numbers::pi;

Rheology rheology_of(const Scene& scene, double amplitude = 1.0) {
  const SuspensionSolver solver(scene);
  const Instant start = solver.start();
  return Rheometer(solver)(solver.solve({start.configuration, scaled(amplitude, start.forcing)}));
}

Scene pair(double gap, const BackgroundFlow& flow) {
  return scene({body(Circle{1}, 160, -1.0 - gap / 2), body(Circle{1}, 160, 1.0 + gap / 2)}, flow);
}

Scene couette(double inner, double outer, double inner_rate, double outer_rate,
              const std::vector<Body>& bodies = {}) {
  return scene(bodies, {},
               {outer_wall(Circle{outer}, 160, RotatingWall{outer_rate}),
                inner_wall(Circle{inner}, 160, RotatingWall{inner_rate})});
}

Curve curve(const Shape& shape) {
  return sample(shape, 128, Side::fluid_outside);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rheology)

// The stresslets of each circle are the reference numbers N3.
BOOST_AUTO_TEST_CASE(stresslets_of_two_circles) {
  const double rate = 0.7;
  const Rheology sheared = rheology_of(pair(0.1, ShearFlow{rate}));
  BOOST_TEST(std::abs(sheared.stresslet - Complex(0.0, 2.0 * rate * 5.69598502258849)) < 1e-11);
  BOOST_TEST(sheared.dissipation == 2.0 * rate * rate * 5.69598502258849,
             boost::test_tools::tolerance(1e-12));
  const Rheology summed =
      rheology_of(pair(0.1, SumFlow{{UniformFlow{{3.0, -1.0}}, ShearFlow{rate, {0.0, 5.0}}}}));
  BOOST_TEST(std::abs(summed.stresslet - sheared.stresslet) < 1e-11);
  BOOST_TEST(summed.dissipation == sheared.dissipation, boost::test_tools::tolerance(1e-11));
  const Rheology stretched = rheology_of(pair(0.1, ExtensionalFlow{rate}));
  BOOST_TEST(std::abs(stretched.stresslet - 2.0 * rate * 16.8631930688144) < 1e-11);
  BOOST_TEST(stretched.dissipation == 4.0 * rate * rate * 16.8631930688144,
             boost::test_tools::tolerance(1e-12));
  const Rheology reversed = rheology_of(pair(0.1, ShearFlow{rate}), -1.0);
  BOOST_TEST(std::abs(reversed.stresslet + sheared.stresslet) < 1e-11);
  BOOST_TEST(std::abs(reversed.dissipation - sheared.dissipation) < 1e-11);
}

// Reference number NA: one circle in a Couette cell.
BOOST_AUTO_TEST_CASE(torque_ratio) {
  const Scene cell = couette(1.0, 3.0, 0.0, 1.0, {body(Circle{0.4}, 96, 2.0)});
  for (const double amplitude : {1.0, -1.0}) {
    const Rheology measured = rheology_of(cell, amplitude);
    BOOST_TEST(std::abs(measured.torque_ratio - 1.03207638279558) < 1e-12);
    // The dissipation is the power of the walls: the free body has none.
    const double torque = -measured.torque_ratio * 4.0 * pi * 9.0 / 8.0;
    BOOST_TEST(measured.dissipation == -torque, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(std::isnan(measured.order_parameter));
    BOOST_TEST(std::isnan(measured.stresslet.real()));
  }
  BOOST_TEST(std::abs(rheology_of(couette(1.0, 3.0, 0.2, 1.0)).torque_ratio - 1.0) < 1e-13);
}

// Reference number C6, and radial flow between cylinders whose walls deform, with the dissipation
// mu Q^2 / pi (1 / R1^2 - 1 / R2^2).
BOOST_AUTO_TEST_CASE(dissipation_between_cylinders) {
  Scene cell = couette(1.0, 2.5, 0.4, -0.7);
  cell.viscosity = 1.3;
  BOOST_TEST(rheology_of(cell).dissipation == 23.532024971889261,
             boost::test_tools::tolerance(1e-12));
  const double flux = 2.0;
  cell.walls[0].motion = RadialWall{-flux / (2.0 * pi * 2.5)};
  cell.walls[1].motion = RadialWall{flux / (2.0 * pi)};
  const Rheology radial = rheology_of(cell);
  BOOST_TEST(radial.dissipation == 1.3 * flux * flux / pi * (1.0 - 1.0 / 6.25),
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::isnan(radial.torque_ratio));
}

// The dissipation that loaded bodies add to a linear flow is a limit of containers whose radius R
// grows and whose walls move with that flow: the total dissipation in the container minus the
// dissipation in the empty container tends to it with an error of order R^-2.
BOOST_AUTO_TEST_CASE(dissipation_of_loaded_bodies_in_a_linear_flow) {
  Eigen::Matrix2d gradient;
  gradient << 0.3, 0.9, -0.2, -0.3;
  const std::vector<Body> bodies{body(Ellipse{1.0, 0.5}, 96, {-1.2, 0.2}, 0.4, {{1.0, -0.5}, 0.6}),
                                 body(Circle{0.7}, 96, {1.1, -0.1}, 0.0, {{-1.0, 0.5}, -0.9})};
  const double excess = rheology_of(scene(bodies, LinearFlow{gradient})).dissipation;
  const double strain2 = 2.0 * 0.3 * 0.3 + 0.5 * 0.7 * 0.7;  // E : E
  const auto contained = [&](double radius) {
    const Scene tank = scene(bodies, {}, {outer_wall(Circle{radius}, 128, LinearWall{gradient})});
    return rheology_of(tank).dissipation - 2.0 * strain2 * pi * radius * radius;
  };
  const double small = contained(30), large = contained(60);
  BOOST_TEST(std::abs(large - excess) < 0.01 * excess);
  BOOST_TEST(std::abs((4.0 * large - small) / 3.0 - excess) < 2e-5 * excess);
}

// If the forces balance in a fluid at rest, the dissipation is the power of the loads.
BOOST_AUTO_TEST_CASE(dissipation_of_pulled_circles) {
  Scene pulled = pair(0.1, {});
  pulled.bodies[0].force = -1.0;
  pulled.bodies[1].force = 1.0;
  BOOST_TEST(rheology_of(pulled).dissipation == 2.0 * .002860847034107639,
             boost::test_tools::tolerance(1e-11));
  // The net force of the held bodies in this stream is zero. They do not move, but the fluid around
  // them is strained more than around free bodies, which increases the dissipation.
  Scene held = pair(0.5, ShearFlow{1});
  for (Body& body : held.bodies) body.held = true;
  const Rheology measured = rheology_of(held);
  const Solved solved(held);
  double power = measured.stresslet.imag();
  for (std::size_t k = 0; k < 2; ++k) {
    const Complex stream = held.bodies[k].position.imag();
    power += dot(solved.load(k).force, -stream) + 0.5 * solved.load(k).torque;
  }
  BOOST_TEST(measured.dissipation == power, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(measured.dissipation > rheology_of(pair(0.5, ShearFlow{1})).dissipation);
}

BOOST_AUTO_TEST_CASE(long_axes) {
  const auto axis = [](const Shape& shape) { return long_axis(curve(shape)); };
  const auto is = [](const std::optional<double>& found, double angle) {
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(std::abs(std::remainder(*found - angle, pi)) < 1e-12);
  };
  is(axis(Ellipse{2, 1}), 0.0);
  is(axis(Ellipse{1, 1.01}), pi / 2);
  is(axis(Superellipse{2, 1, 6}), 0.0);
  is(axis(Star{1, 0.2, 2}), 0.0);
  is(axis(Star{1, -0.2, 2}), pi / 2);
  is(long_axis(place(curve(Ellipse{2, 1}), {5, -3}, 0.7)), 0.7);
  for (const Shape& shape : {Shape{Circle{2}}, Shape{Ellipse{2, 2}}, Shape{Star{1, 0.2, 3}},
                             Shape{Star{1, 0.2, 5}}, Shape{Superellipse{1, 1, 4}}}) {
    BOOST_TEST(!axis(shape).has_value());
    BOOST_TEST(!long_axis(place(curve(shape), {5, -3}, 0.7)).has_value());
  }
}

BOOST_AUTO_TEST_CASE(order_parameter) {
  // Over half a turn of a Jeffery orbit, the mean of cos 2 theta is (lambda - 1) / (lambda + 1).
  Scene jeffery = scene({body(Ellipse{3, 1}, 64, 0.0)}, ShearFlow{1});
  jeffery.solver.tolerance = 1e-6;
  const double half_turn = pi * (3.0 + 1.0 / 3.0);
  jeffery.time = {half_turn, half_turn / 100, SteppingMethod::rk4};
  double mean = 0.0;
  for (const Frame& frame : frames_of(jeffery)) {
    BOOST_TEST(std::abs(frame.rheology.order_parameter -
                        std::cos(2.0 * frame.bodies[0].orientation)) < 1e-12);
    if (frame.t > 0.0) mean += frame.rheology.order_parameter / 100;
  }
  BOOST_TEST(std::abs(mean - 0.5) < 1e-5);

  // The two ellipses are at right angles, so their contributions cancel; the circle has no long
  // axis and does not count.
  Scene three = scene({body(Ellipse{1, 0.5}, 96, -4.0, 0.3), body(Ellipse{0.5, 1}, 96, 0.0, 0.3),
                       body(Circle{1}, 64, 4.0, 0.5)},
                      ExtensionalFlow{1});
  BOOST_TEST(std::abs(rheology_of(three).order_parameter) < 1e-12);
  three.flow = UniformFlow{1.0};
  BOOST_TEST(std::isnan(rheology_of(three).order_parameter));

  // In a Couette cell, the flow follows circles about the centre of the outer wall.
  Scene cell = couette(
      1.0, 4.0, 1.0, 0.0,
      {body(Ellipse{0.6, 0.3}, 96, {0.0, 2.5}, 0.0), body(Ellipse{0.3, 0.6}, 96, {2.5, 0.0}, 0.2)});
  BOOST_TEST(std::abs(rheology_of(cell).order_parameter - (1.0 + std::cos(0.4)) / 2) < 1e-12);
}

BOOST_AUTO_TEST_CASE(couette_cells) {
  BOOST_TEST(is_couette_cell(couette(1, 2, 0, 1)));
  BOOST_TEST(!is_couette_cell(couette(1, 2, 1, 1)));
  Scene other = couette(1, 2, 0, 1);
  other.walls[1].motion = FixedWall{};
  BOOST_TEST(is_couette_cell(other));
  other.walls[1].motion = TranslatingWall{1.0};
  BOOST_TEST(!is_couette_cell(other));
  other.walls.pop_back();
  BOOST_TEST(!is_couette_cell(other));
  other = couette(1, 9, 0, 1);
  other.walls.push_back(inner_wall(Circle{0.5}, 64, {}, 5.0));
  BOOST_TEST(!is_couette_cell(other));
}

// The dissipation is undefined with a net force, a flow that is not linear, or a wall that deforms.
// The stresslets are defined in all of these cases.
BOOST_AUTO_TEST_CASE(what_is_not_defined) {
  Scene one = scene({body(Ellipse{1, 0.5}, 96, 0.3)}, TaylorGreenFlow{1});
  const auto undefined_dissipation = [](const Scene& scene) {
    const Rheology measured = rheology_of(scene);
    BOOST_TEST(std::isfinite(measured.stresslet.real()));
    BOOST_TEST(std::isnan(measured.torque_ratio));
    return std::isnan(measured.dissipation);
  };
  BOOST_TEST(undefined_dissipation(one));
  BOOST_TEST(std::isnan(rheology_of(one).order_parameter));
  one.flow = SumFlow{{ShearFlow{1}, TaylorGreenFlow{1}}};
  BOOST_TEST(undefined_dissipation(one));
  BOOST_TEST(std::isnan(rheology_of(one).order_parameter));
  one.flow = SumFlow{{ShearFlow{1}, UniformFlow{1}}};
  BOOST_TEST(!std::isnan(rheology_of(one).order_parameter));
  one.flow = ShearFlow{1};
  BOOST_TEST(!undefined_dissipation(one));
  one.gauge_length = 50.0;
  BOOST_TEST(!undefined_dissipation(one));
  one.bodies[0].force = 1.0;
  BOOST_TEST(undefined_dissipation(one));
  one.bodies[0].force = 0.0;
  one.bodies[0].held = true;
  BOOST_TEST(undefined_dissipation(one));
  Scene source = scene({body(Ellipse{1, 0.5}, 96, 0.3)}, ShearFlow{1},
                       {inner_wall(Circle{1}, 96, RadialWall{1}, {4.0, 0.0})});
  BOOST_TEST(undefined_dissipation(source));
}

// Without a net force, the fluid at infinity moves with a single held disk.
BOOST_AUTO_TEST_CASE(velocity_at_infinity) {
  const double rate = 0.7;
  const Body held = held_body(Circle{1.0}, 64, {0.3, 2.0}, 0.0, {{0.4, -0.2}, 0.0});
  const Rheology free = rheology_of(scene({held}, ShearFlow{rate}));
  BOOST_TEST(std::abs(free.uniform_velocity - (held.velocity - rate * 2.0)) < 1e-12);
  for (const Scene& known :
       {with_gauge(scene({held}, ShearFlow{rate}), 10.0), pair(0.5, ShearFlow{rate}),
        scene({held}, {}, {outer_wall(Circle{5.0}, 96)})}) {
    BOOST_TEST(std::isnan(rheology_of(known).uniform_velocity.real()));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
