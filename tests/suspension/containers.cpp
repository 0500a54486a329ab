// Tests bodies and inner walls in containers against the reference numbers C5, C6, C7, N9, NA of
// the specification in two systems of units, and the whole resistance of eccentric circles against
// its closed form down to small gaps.

#include "expected.hpp"
#include "support/eccentric_annulus.hpp"

namespace stokesbook::test {
namespace {

constexpr double to_rounding = 1e-12;

// The motion of the outer circle is the sum of a translation and a rotation, which are separate
// wall motions in the scene format. The solver solves for each of them, and the loads are added.
Load solved_inner_load(const EccentricAnnulus& annulus, double load_tolerance) {
  const auto part = [&](const RigidMotion& inner, const WallMotion& outer) {
    Scene both =
        scene({held_body(Circle{annulus.inner_radius}, 0, annulus.inner_centre, 0, inner)}, {},
              {outer_wall(Circle{annulus.outer_radius}, 0, outer, annulus.outer_centre)});
    // The densities are 1e4 times the data, so rounding prevents a residual of 1e-14. The solver
    // estimates rounding errors too, so its tolerance is not smaller than the checked one.
    both.solver.tolerance = std::max(3e-10, load_tolerance);
    return Solved(resolved(both)).load(0);
  };
  const Load a = part(annulus.inner, TranslatingWall{annulus.outer.velocity});
  const Load b = part({}, RotatingWall{annulus.outer.omega});
  return {a.force + b.force, a.torque + b.torque};
}

// In lubrication, loads are the sensitive results: they amplify rounding errors by 1 / gap.
void check_inner_load(const EccentricAnnulus& annulus, double gap) {
  const Load exact = inner_load(annulus, 1.0);
  const double size = std::abs(exact.force) + std::abs(exact.torque);
  const double tolerance_of_load = 1e-12 / gap;
  BOOST_TEST(distance(solved_inner_load(annulus, tolerance_of_load), exact) <
             tolerance_of_load * size);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(containers)

BOOST_AUTO_TEST_CASE(circle_in_a_container_C5) {
  const auto loaded = [](const Load& load) {
    return scene({body(Circle{1}, 64, {}, 0.0, load)}, {}, {outer_wall(Circle{3}, 96)});
  };
  check(loaded({{0.6, -0.8}, 0.0}),
        {{0, RigidMotion{0.02376281090475681 * Complex{0.6, -0.8}, 0}, {}, {}}}, to_rounding);
  check(loaded({0.0, 1.0}), {{0, RigidMotion{0.0, 0.070735530263064594}, {}, {}}}, to_rounding);
}

BOOST_AUTO_TEST_CASE(couette_C6) {
  Scene c6 = scene({}, {},
                   {inner_wall(Circle{1}, 96, RotatingWall{.4}),
                    outer_wall(Circle{2.5}, 96, RotatingWall{-.7})});
  c6.viscosity = 1.3;
  const double torque = 21.392749974444783;
  check(c6, {{0, {}, Load{0.0, torque}, {}}, {1, {}, Load{0.0, -torque}, {}}}, 1e-11);
  const Solved solved(c6);
  // The dissipation is the power of both walls.
  BOOST_TEST(.4 * solved.load(0).torque - .7 * solved.load(1).torque == 23.532024971889261,
             boost::test_tools::tolerance(1e-12));
  for (const double angle : {0.0, 1.0, 4.0}) {
    const Complex direction = std::polar(1.0, angle);
    const Complex velocity = solved.velocity(ComplexVector{{1.7 * direction}})[0];
    BOOST_TEST(std::abs(velocity + 0.77588235294117647 * perp(direction)) < to_rounding);
  }
}

BOOST_AUTO_TEST_CASE(eccentric_C7) {
  const auto cell = [](double inner, double outer) {
    return scene({}, {},
                 {inner_wall(Circle{1}, 128, RotatingWall{inner}),
                  outer_wall(Circle{2}, 160, RotatingWall{outer}, {0, .5})});
  };
  check(cell(1, 0), {{0, {}, Load{-13.83366424161095, 20.023919863023254}, {}}}, 1e-11);
  check(cell(0, 1), {{0, {}, Load{-55.334656966443802, -13.107087742217779}, {}}}, 1e-11);
}

BOOST_AUTO_TEST_CASE(circle_in_extension_N9) {
  Eigen::Matrix2d gradient;
  gradient << 1, 0, 0, -1;
  check(scene({body(Circle{.5}, 64, 1.2)}, {}, {outer_wall(Circle{3}, 96, LinearWall{gradient})}),
        {{0, RigidMotion{1.28078353552061, 0.0}, {}, {}}}, to_rounding);
}

BOOST_AUTO_TEST_CASE(circle_in_a_couette_cell_NA) {
  const Scene na = scene({body(Circle{.4}, 96, 2)}, {},
                         {inner_wall(Circle{1}, 128), outer_wall(Circle{3}, 160, RotatingWall{1})});
  check(na,
        {{0, RigidMotion{{0, 1.69576668946189}, 1.09942194421272}, {}, {}},
         {1, {}, Load{{0, .377572056655290}, -14.5906361196035}, {}}},
        1e-11);
  // L0 = 4 pi B is the torque in the empty cell.
  const double empty = -4 * std::numbers::pi * 9.0 / 8.0;
  BOOST_TEST(Solved(na).load(1).torque / empty == 1.03207638279558,
             boost::test_tools::tolerance(1e-12));
}

// The inner wall is a source and the outer wall an equal sink: u = a g / r, and neither wall has a
// load.
BOOST_AUTO_TEST_CASE(radial_walls) {
  const Scene source = scene({}, {},
                             {inner_wall(Circle{0.8}, 96, RadialWall{0.7}),
                              outer_wall(Circle{2.0}, 96, RadialWall{-0.28})});
  check(source, {{0, {}, Load{}, {}}, {1, {}, Load{}, {}}}, to_rounding);
  const Complex point{1.2, -0.5};
  const Complex velocity = Solved(source).velocity(ComplexVector{{point}})[0];
  BOOST_TEST(std::abs(velocity - 0.56 * point / std::norm(point)) < to_rounding);
}

// Both circles have random motions, towards each other and past each other.
BOOST_AUTO_TEST_CASE(eccentric_annuli) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double gap : {0.3, 0.1, 0.03, 0.01}) {
    for (int trial = 0; trial < 2; ++trial) {
      EccentricAnnulus annulus{1.0, 1.6 + 0.4 * uniform(random), Complex{0.2, 0.1},
                               0.0, random_motion(random),       random_motion(random)};
      const double eccentricity = annulus.outer_radius - 1 - gap;
      annulus.outer_centre = annulus.inner_centre + std::polar(eccentricity, 3 * uniform(random));
      check_inner_load(annulus, gap);
    }
  }
}

// The gap of this journal bearing nearly closes.
BOOST_AUTO_TEST_CASE(journal_bearings, *boost::unit_test::label("full")) {
  for (const double gap : {0.003, 0.001}) {
    check_inner_load({1.0, 1.5, 0.0, {0.0, 0.5 - gap}, {0.0, 0.7}, {0.0, -0.4}}, gap);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
