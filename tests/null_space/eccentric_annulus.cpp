// Checks the resistance of a circle in an eccentric circular container, F_x, F_y and L of any
// motion, against the closed form (04.10): reference numbers C7a and C7b, and random annuli with
// gaps that the plain trapezoid rule resolves.

#include "support/eccentric_annulus.hpp"

#include <random>

#include <boost/test/unit_test.hpp>

namespace stokesbook::test {
namespace {

StokesProblem problem_of(const EccentricAnnulus& annulus, double mu) {
  return annulus_problem(annulus, mu, 160, 128);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(eccentric_annulus)

BOOST_AUTO_TEST_CASE(reference_C7) {
  const EccentricAnnulus inner_turns{1, 2, 0.0, {0, 0.5}, {0.0, 1}, {}};
  const EccentricAnnulus outer_turns{1, 2, 0.0, {0, 0.5}, {}, {0.0, 1}};
  const Load c7a{-13.83366424161095, 20.023919863023254};
  const Load c7b{-55.334656966443802, -13.107087742217779};
  BOOST_TEST(distance(inner_load(inner_turns, 1.0), c7a) < 1e-13);
  BOOST_TEST(distance(inner_load(outer_turns, 1.0), c7b) < 1e-13);
  for (const ClosureForm form : all_forms) {
    BOOST_TEST(distance(solve_bounded(problem_of(inner_turns, 1.0), form).loads[0], c7a) < 1e-11);
    BOOST_TEST(distance(solve_bounded(problem_of(outer_turns, 1.0), form).loads[0], c7b) < 1e-11);
  }
  // Reciprocity: the outer circle's torque about its centre, when the inner circle turns, is the
  // inner circle's torque of C7b.
  const Load outer = solve_bounded(problem_of(inner_turns, 1.0), ClosureForm::reduced).loads[1];
  BOOST_TEST(outer.torque == c7b.torque, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(random_annuli) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Complex{uniform(random), uniform(random)}; };
  for (int trial = 0; trial < 4; ++trial) {
    EccentricAnnulus annulus{1.0, 1.8 + 0.5 * uniform(random), vector(),
                             0.0, {vector(), uniform(random)}, {vector(), uniform(random)}};
    // The least gap is about a third of the difference of the radii.
    const double eccentricity = (annulus.outer_radius - 1.0) * (0.35 + 0.3 * uniform(random));
    annulus.outer_centre = annulus.inner_centre + std::polar(eccentricity, 3 * uniform(random));
    const double mu = trial % 2 == 0 ? 1.0 : 1.3;
    const Load exact = inner_load(annulus, mu);
    for (const ClosureForm form : all_forms) {
      const Load load = solve_bounded(problem_of(annulus, mu), form).loads[0];
      BOOST_TEST(distance(load, exact) < 1e-10 * (std::abs(exact.force) + std::abs(exact.torque)));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
