// Checks how the closure's scale changes the conditioning. Power's border compares a velocity
// with a force, so its condition number grows with the body's size in either direction; the scaled
// border (03.8) and the reduced form (03.10) have condition number 2 on a circle of any size. Norms
// are mean squares over the curve.

#include <boost/test/unit_test.hpp>

#include "support/mean_square.hpp"
#include "support/problems.hpp"

namespace stokesbook::test {
namespace {

using std::numbers::pi;

StokesProblem circle_problem(double radius) {
  return {{free_body(Circle{radius}, 32, {{0.3, 0.1}})}, 1.0, {}, 1.0};
}

StokesProblem held_circle_problem(double radius, double mu) {
  // In this gauge, the eigenvalues of the circle's own block are -1 and -1/2.
  const double gauge = std::sqrt(std::numbers::e) * radius;
  return {{held_body(Circle{radius}, 32, {}, {1.0, 0.0})}, mu, {}, gauge};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(conditioning)

// Power's matrix on a circle has the singular values 1/2 and 1 of -1/2 + D, the singular values
// {1, 2 pi a} of the border of a translation, and {a, 2 pi a^2} of the border of a rotation.
BOOST_AUTO_TEST_CASE(power_depends_on_size) {
  const auto condition = [](double a) {
    return mean_square_condition(circle_problem(a), ClosureForm::power_bordered);
  };
  BOOST_TEST(condition(1e-2) == 1.0 / (2 * pi * 1e-4), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(condition(1.0) == 4 * pi, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(condition(1e2) == 4 * pi * 1e4, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(scaled_and_reduced_do_not) {
  for (const double a : {1e-6, 1e-2, 1.0, 1e2, 1e6}) {
    for (const ClosureForm form : {ClosureForm::scaled_bordered, ClosureForm::reduced}) {
      const double condition = mean_square_condition(circle_problem(a), form);
      BOOST_TEST(condition == 2.0, boost::test_tools::tolerance(1e-9));
    }
  }
}

// For held bodies the viscosity enters Power's border as well.
BOOST_AUTO_TEST_CASE(power_depends_on_viscosity) {
  const auto condition = [](double mu, ClosureForm form) {
    return mean_square_condition(held_circle_problem(1.0, mu), form);
  };
  const double at_one = condition(1.0, ClosureForm::power_bordered);
  BOOST_TEST(condition(1e-3, ClosureForm::power_bordered) > 2.0 * at_one);
  BOOST_TEST(condition(1e3, ClosureForm::power_bordered) > 10.0 * at_one);
  for (const ClosureForm form : {ClosureForm::scaled_bordered, ClosureForm::reduced}) {
    const double scaled = condition(1.0, form);
    BOOST_TEST(condition(1e-3, form) == scaled, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(condition(1e3, form) == scaled, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
