// Checks loaded and freely floating ellipses against their closed forms, in all three forms of the
// closure. The test finds a wrong sign, scale or factor in a border, a functional or a singularity.

#include "support/closed_forms.hpp"

#include <boost/test/unit_test.hpp>

#include "support/problems.hpp"

namespace stokesbook::test {
namespace {

// 96 nodes resolve moderate ellipses to rounding, also with a Stokeslet at the centre: the error is
// about m^(N/2) with m = (a - b) / (a + b) = 1/3 (03.16).
using std::numbers::pi;

constexpr Eigen::Index n_nodes = 96;
constexpr double rounding = 2e-14;

// Returns the shear flow u = (rate y, 0).
ComplexVector shear(const ComplexVector& x, double rate) {
  return rate * x.imag().cast<Complex>();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(closed_forms)

BOOST_AUTO_TEST_CASE(reference_circle_C1) {
  const Component body = free_body(Circle{0.7}, 32, {}, {{1.0, 0.5}, 0.7});
  const StokesProblem problem{{body}, 1.3, {}, 1.0};
  for (const ClosureForm form : all_forms) {
    const RigidMotion motion = solve_dense(problem, form).motions[0];
    BOOST_TEST(std::abs(motion.velocity - Complex{0.052440019981085223, 0.026220009990542611}) <
               1e-15);
    BOOST_TEST(std::abs(motion.omega - 0.087447770929612822) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(reference_ellipse_C2) {
  const Component body = free_body(Ellipse{2, 1}, n_nodes, {}, {{1.0, 1.0}, 1.0});
  const StokesProblem problem{{body}, 1.3, {}, 1.0};
  for (const ClosureForm form : all_forms) {
    const RigidMotion motion = solve_dense(problem, form).motions[0];
    BOOST_TEST(std::abs(motion.velocity - Complex{0.01598904584149723, -0.004415434042079095}) <
               1e-15);
    BOOST_TEST(std::abs(motion.omega - 0.02448537586029159) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(reference_ellipse_in_shear_C3) {
  const Component body = free_body(Ellipse{2, 1}, n_nodes, {0.0, 0.5});
  const StokesProblem problem{{body}, 1.0, shear(body.curve.x, 1.0), {}};
  for (const ClosureForm form : all_forms) {
    const RigidMotion motion = solve_dense(problem, form).motions[0];
    BOOST_TEST(std::abs(motion.velocity) < rounding);
    BOOST_TEST(std::abs(motion.omega + 0.33790930823955808) < rounding);
  }
}

// Varies the direction of the load, the ellipse's place and angle, viscosity, length and gauge.
BOOST_AUTO_TEST_CASE(loaded_ellipses) {
  for (const double length : {1e-3, 1.0, 1e3}) {
    for (const double mu : {1.0, 1.3}) {
      for (const double orientation : {0.4, 2.0, -1.1}) {
        const Ellipse ellipse{1.7 * length, length};
        const Load load{{0.3, -1.1}, 0.6 * length};
        const Pose pose{length * Complex{3, -2}, orientation};
        const StokesProblem problem{
            {free_body(ellipse, n_nodes, pose, load)}, mu, {}, 7.0 * length};
        const RigidMotion exact = loaded_ellipse(ellipse, orientation, load, mu, 7.0 * length);
        for (const ClosureForm form : all_forms) {
          const RigidMotion motion = solve_dense(problem, form).motions[0];
          // Power's border mixes units, so its results are less accurate at 1e3.
          const double tolerance = form == ClosureForm::power_bordered ? 1e-11 : rounding;
          BOOST_TEST(distance(motion, exact, length) < tolerance);
        }
      }
    }
  }
}

// A free ellipse moves with the flow at its centre and turns as in Jeffery's solution, for any
// angle.
BOOST_AUTO_TEST_CASE(ellipses_in_shear) {
  const Complex centre{0.8, 1.9};
  const double rate = -1.4;
  for (const double orientation : {0.0, 0.7, 1.9, 3.0}) {
    const Ellipse ellipse{1.0, 1.8};
    const Component body = free_body(ellipse, n_nodes, {centre, orientation});
    const StokesProblem problem{{body}, 1.3, shear(body.curve.x, rate), {}};
    const RigidMotion exact{rate * centre.imag(),
                            free_ellipse_omega(ellipse, orientation, -rate, 0.0, 0.5 * rate)};
    for (const ClosureForm form : all_forms) {
      BOOST_TEST(distance(solve_dense(problem, form).motions[0], exact) < rounding);
    }
  }
}

// The resistance of a held circle is the inverse of its mobility (03.12), for any gauge length
// above the degenerate one.
BOOST_AUTO_TEST_CASE(held_circle_with_gauge) {
  const double a = 0.7, mu = 1.3;
  const RigidMotion motion{{0.4, -1.2}, 2.1};
  for (const double ell : {5.0, 40.0, 1e6}) {
    const StokesProblem problem{{held_body(Circle{a}, 32, {{1, 2}}, motion)}, mu, {}, ell};
    const Load exact{4 * pi * mu * motion.velocity / (0.5 - std::log(a / ell)),
                     4 * pi * mu * a * a * motion.omega};
    for (const ClosureForm form : all_forms) {
      BOOST_TEST(distance(solve_dense(problem, form).loads[0], exact) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
