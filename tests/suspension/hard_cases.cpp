// Tests extreme cases: a gap of 1e-4, a body twenty times as long as wide, a tip in a valley, and
// lengths of 1e-6 and 1e6.

#include "expected.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::test {
namespace {

Scene circle_pair(double gap, double tolerance) {
  Scene pair = scene({body(Circle{1}, 64, -1 - gap / 2), body(Circle{1}, 64, 1 + gap / 2)},
                     ExtensionalFlow{1});
  pair.solver.tolerance = tolerance;
  const SuspensionSolver planner(pair);
  const std::vector<int> nodes = recommended_nodes(planner);
  pair.bodies[0].n_nodes = nodes[0];
  pair.bodies[1].n_nodes = nodes[1];
  return pair;
}

// Returns a five-armed star with an arm in the valley between two arms of another star.
Scene tip_in_valley(int n_nodes, const BackgroundFlow& flow, double tolerance) {
  const Star star{1, 0.25, 5};
  using std::numbers::pi;
  Scene pair = scene({body(star, n_nodes, {}, pi / 5), body(star, n_nodes, 2.05, pi)}, flow);
  pair.solver.tolerance = tolerance;
  return pair;
}

void check_slender_body(double orientation, const std::vector<Units>& units_of_load) {
  const Ellipse needle{2, 0.1};
  const double omega = free_ellipse_omega(needle, orientation, -1.0, 0.0, 0.5);
  check(scene({body(needle, 352, {0.5, 0.8}, orientation)}, ShearFlow{1}),
        {{0, RigidMotion{0.8, omega}, {}, {}}}, 1e-12);
  const Load load{{0.7, -0.3}, 0.2};
  const RigidMotion exact = loaded_ellipse(needle, orientation, load, 1.0, 5.0);
  check(with_gauge(scene({body(needle, 800, {0.5, 0.8}, orientation, load)}), 5.0),
        {{0, exact, {}, {}}}, 1e-11, units_of_load);
}

// There is no closed form: results with other nodes, the mirror image and reciprocity must agree.
void check_tip_in_valley(int coarse_nodes, int fine_nodes, double tolerance) {
  const Solved coarse(tip_in_valley(coarse_nodes, ShearFlow{1}, tolerance)),
      fine(tip_in_valley(fine_nodes, ShearFlow{1}, tolerance));
  BOOST_TEST(coarse.solution.gaps.front().points.gap < 0.1);
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(distance(coarse.motion(k), fine.motion(k)) < tolerance);
    // The pair is its own mirror image in y = 0, which reverses shear, so U_x must vanish.
    BOOST_TEST(std::abs(fine.motion(k).velocity.real()) < tolerance);
  }
  const auto with_torque = [&](std::size_t k) {
    Scene pair = tip_in_valley(coarse_nodes, {}, tolerance);
    pair.bodies[k].torque = 1.0;
    return Solved(pair).motion(1 - k).omega;
  };
  BOOST_TEST(std::abs(with_torque(0) - with_torque(1)) < tolerance);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hard_cases)

// Each circle has about 1900 nodes.
BOOST_AUTO_TEST_CASE(gap_of_1e_4, *boost::unit_test::label("full")) {
  const double gap = 1e-4, tolerance = 1e-6;
  const Solved solved(circle_pair(gap, tolerance));
  const double exact = CirclePair{1, gap}.speed_in_extension(1);
  BOOST_TEST(std::abs(solved.motion(1).velocity - exact) < tolerance);
  BOOST_TEST(std::abs(solved.motion(0).velocity + exact) < tolerance);
  BOOST_TEST(solved.solution.error_estimate < tolerance);
}

BOOST_AUTO_TEST_CASE(slender_body) {
  check_slender_body(0.3, {{}});
}

BOOST_AUTO_TEST_CASE(slender_body_at_any_angle, *boost::unit_test::label("full")) {
  for (const double orientation : {0.0, 0.3, 1.5}) {
    check_slender_body(orientation, {{}, {1e3, 1.3, 2.5}});
  }
}

BOOST_AUTO_TEST_CASE(star_tip_in_a_valley) {
  check_tip_in_valley(224, 288, 1e-5);
}

BOOST_AUTO_TEST_CASE(star_tip_in_a_valley_to_eight_digits, *boost::unit_test::label("full")) {
  check_tip_in_valley(512, 640, 1e-8);
}

// The lengths are a micrometre and a thousand kilometres, if the unit is a metre.
BOOST_AUTO_TEST_CASE(extreme_units) {
  const std::vector<Units> extreme{
      {1e-6, 1.3, 2.5}, {1e6, 1, 1}, {1, 1e-6, 1e6}, {1e-6, 1e-3, 1e3}};
  const RigidMotion left{{0, .157664988452569}, -.302612470846086};
  check(scene({body(Circle{1}, 128, -1.05), body(Circle{1}, 128, 1.05)}, ShearFlow{1}),
        {{0, left, {}, Complex{0, 5.69598502258849}}}, 1e-11, extreme);
  check(scene({body(Circle{.4}, 96, 2)}, {},
              {inner_wall(Circle{1}, 128), outer_wall(Circle{3}, 160, RotatingWall{1})}),
        {{0, RigidMotion{{0, 1.69576668946189}, 1.09942194421272}, {}, {}},
         {1, {}, Load{{0, .377572056655290}, -14.5906361196035}, {}}},
        1e-11, extreme);
  const Load load{{1.0, 0.0}, 0.0};
  check(with_gauge(scene({body(Star{1, 0.2, 5}, 192, {}, 0.0, load)}), 1.0),
        {{0, RigidMotion{0.031871196888335535, 0.0}, {}, {}}}, 1e-13, extreme);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
