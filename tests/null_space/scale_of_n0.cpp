// Checks that sign and scale of N_0, and the form of the closure, change the density and the
// conditioning, but neither motions nor loads.

#include <boost/test/unit_test.hpp>

#include "support/spectra.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {
namespace {

// A Couette cell holds a free ellipse and a free circle. All lengths are multiples of `length`, and
// each curve has n nodes.
StokesProblem cell(double length, Eigen::Index n) {
  const auto at = [&](Complex position, double angle) { return Pose{length * position, angle}; };
  return {{held_body(Circle{length}, n, at(0, 0), {0.0, 0.4}),
           free_body(Ellipse{0.5 * length, 0.25 * length}, n, at({1.8, 0.4}, 0.9),
                     {{0.3, -0.2}, 0.1 * length}),
           free_body(Circle{0.35 * length}, n, at({-1.3, 1.4}, 0.0)),
           enclosing_wall(Circle{3 * length}, n, at({0.1, 0.1}, 0.0), {0.0, -0.7})},
          1.3,
          {},
          {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(scale_of_n0)

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_it) {
  const StokesProblem problem = cell(1.0, 96);
  const Completion expected = solve_bounded(problem, ClosureForm::reduced);
  const double length = perimeter(problem.components[3].curve);
  for (const ClosureForm form : all_forms) {
    for (const double scale : {-1.0, length}) {
      const Completion result = solve_bounded(problem, form, scale);
      for (std::size_t k = 0; k < 4; ++k) {
        BOOST_TEST(distance(result.motions[k], expected.motions[k]) < 1e-12);
        BOOST_TEST(distance(result.loads[k], expected.loads[k]) < 1e-11);
      }
    }
  }
}

// The recommended system has the same condition number in any unit of length. The condition number
// of Power's system depends on the unit.
BOOST_AUTO_TEST_CASE(conditioning_in_any_unit) {
  const auto recommended = [](double length) {
    return condition_number(assemble_bounded(cell(length, 32), ClosureForm::reduced).matrix);
  };
  const auto with_unscaled_term = [](double length) {
    const StokesProblem problem = cell(length, 32);
    const double unscaled = -perimeter(problem.components[3].curve);
    return condition_number(
        assemble_bounded(problem, ClosureForm::power_bordered, unscaled).matrix);
  };
  const double expected = recommended(1.0);
  BOOST_TEST(expected < 50.0);
  BOOST_TEST(recommended(20.0) == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(recommended(0.05) == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(with_unscaled_term(20.0) > 10 * with_unscaled_term(1.0));
  BOOST_TEST(with_unscaled_term(0.05) > 10 * with_unscaled_term(1.0));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
