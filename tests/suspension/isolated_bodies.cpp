// Tests one body in an unbounded fluid against the reference numbers C1, C2, C3, N1, N2 of the
// specification, in two systems of units, and the field around a loaded circle against its closed
// form. The stresslets are computed from the density and verify it.

#include "expected.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::test {
namespace {

constexpr double rounding = 1e-13;

Load unit_load(int direction) {
  if (direction == 2) return {0.0, 1.0};
  return {direction == 0 ? Complex{1.0} : imaginary, 0.0};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(isolated_bodies)

BOOST_AUTO_TEST_CASE(circle_C1) {
  Scene c1 = with_gauge(scene({body(Circle{0.7}, 32, {}, 0.0, {{1.0, 0.5}, 0.7})}), 1.0);
  c1.viscosity = 1.3;
  check(c1,
        {{0,
          RigidMotion{{0.052440019981085223, 0.026220009990542611}, 0.087447770929612822},
          {},
          {}}},
        rounding);
}

BOOST_AUTO_TEST_CASE(ellipse_C2) {
  // The reference has the gauge length 1, for which the velocity along the short axis is opposite
  // to the force along this axis. Another gauge length adds a uniform velocity.
  const double gauge = 3.0;
  const Load load{{1.0, 1.0}, 1.0};
  Scene c2 = with_gauge(scene({body(Ellipse{2, 1}, 96, {}, 0.0, load)}), gauge);
  c2.viscosity = 1.3;
  RigidMotion motion{{0.01598904584149723, -0.004415434042079095}, 0.02448537586029159};
  motion.velocity += std::log(gauge) / (4.0 * std::numbers::pi * c2.viscosity) * load.force;
  check(c2, {{0, motion, {}, {}}}, rounding);
}

BOOST_AUTO_TEST_CASE(ellipse_in_shear_C3) {
  const Complex stresslet{1.2854889522196489, 13.311763977068673};
  check(scene({body(Ellipse{2, 1}, 96, {}, 0.5)}, ShearFlow{1}),
        {{0, RigidMotion{0.0, -0.33790930823955808}, {}, stresslet}}, rounding);
}

BOOST_AUTO_TEST_CASE(star_N1) {
  const double mobility[] = {0.031871196888335535, 0.031871196888335535, 0.064313453523979353};
  for (int i = 0; i < 3; ++i) {
    const Load load = unit_load(i);
    const RigidMotion motion{mobility[i] * load.force, mobility[i] * load.torque};
    check(with_gauge(scene({body(Star{1, 0.2, 5}, 192, {}, 0.0, load)}), 1.0),
          {{0, motion, {}, {}}}, rounding);
  }
  check(scene({body(Star{1, 0.2, 5}, 192, {})}, ShearFlow{1}),
        {{0, RigidMotion{0.0, -0.5}, {}, Complex{0.0, 7.546596065576944}}}, rounding);
}

BOOST_AUTO_TEST_CASE(lopsided_body_N2) {
  const RigidMotion columns[] = {
      {{0.041946286524008621, 2.9207185698430717e-4}, -0.0042367069525271845},
      {{2.9207185698430717e-4, 0.028597241322518053}, -0.0024189436540131763},
      {{-0.0042367069525271845, -0.0024189436540131763}, 0.068063075882533061}};
  for (int i = 0; i < 3; ++i) {
    check(with_gauge(scene({body(lopsided_curve(), 160, {}, 0.0, unit_load(i))}), 1.0),
          {{0, columns[i], {}, {}}}, rounding);
  }
  const RigidMotion in_shear{{0.013264317184109857, 0.038045820996011732}, -0.34278665599347508};
  const Complex stresslet{-0.075772533699336, 6.5450393096611492};
  check(scene({body(lopsided_curve(), 160, {})}, ShearFlow{1}), {{0, in_shear, {}, stresslet}},
        rounding);
}

// The loaded ellipses have random positions, angles and gauge lengths.
BOOST_AUTO_TEST_CASE(loaded_ellipses) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 6; ++trial) {
    const Ellipse ellipse{1.0, 1.0 + 0.15 * trial};
    const double orientation = 0.7 * trial, gauge = 1.0 + trial;
    const Load load = random_load(random);
    const RigidMotion exact = loaded_ellipse(ellipse, orientation, load, 1.0, gauge);
    const Complex position{0.3 * trial, -2.0};
    check(with_gauge(scene({body(ellipse, 96, position, orientation, load)}), gauge),
          {{0, exact, {}, {}}}, rounding);
  }
}

// In any linear flow, a free ellipse moves with the velocity at its centre and turns by Jeffery's
// formula.
BOOST_AUTO_TEST_CASE(ellipses_in_linear_flows) {
  Eigen::Matrix2d gradient;
  gradient << 0.4, -1.1, 0.3, -0.4;
  for (const double orientation : {0.0, 0.9, 2.4}) {
    const Ellipse ellipse{1.6, 1};
    const double omega =
        free_ellipse_omega(ellipse, orientation, gradient(1, 0) - gradient(0, 1), gradient(0, 0),
                           0.5 * (gradient(0, 1) + gradient(1, 0)));
    const Eigen::Vector2d drift = gradient * Eigen::Vector2d{1.2, -0.7};
    check(scene({body(ellipse, 96, {1.2, -0.7}, orientation)}, LinearFlow{gradient}),
          {{0, RigidMotion{{drift[0], drift[1]}, omega}, {}, {}}}, rounding);
  }
}

// The points range from a hundredth of the radius to a thousand radii. The rotlet of a circle is
// exact outside of the circle.
BOOST_AUTO_TEST_CASE(field_around_a_loaded_circle) {
  for (const Units& units : two_units) {
    const double a = 0.7 * units.length, ell = 2.0 * units.length;
    const Load load = in_units(Load{{1.0, -0.4}, 0.9}, units);
    const Complex centre = units.length * Complex{0.3, 0.5};
    Scene one = with_gauge(scene({body(Circle{a}, 64, centre, 0.0, load)}), ell);
    one.viscosity = units.viscosity;
    const Solved solved(one);
    ComplexVector points(40), exact(40);
    for (Eigen::Index i = 0; i < 40; ++i) {
      const double r = a * (1.0 + std::pow(10.0, -2.0 + 5.0 * static_cast<double>(i) / 39.0));
      const Complex arm = std::polar(r, 1.7 * static_cast<double>(i));
      points[i] = centre + arm;
      exact[i] = velocity_around_circle(arm, a, load.force, units.viscosity, ell) +
                 perp(arm) * load.torque / (4 * std::numbers::pi * units.viscosity * r * r);
    }
    BOOST_TEST((solved.velocity(points) - exact).cwiseAbs().maxCoeff() <
               rounding * units.velocity());
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
