// Checks flows between concentric circles against closed forms: the rotating cell of reference C6,
// and a circle that moves in a container.

#include <boost/test/unit_test.hpp>

#include "double_layer/stresslet_sum.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {
namespace {

constexpr double pi = std::numbers::pi;

StokesProblem concentric(double inner, double outer, const RigidMotion& motion, double outer_omega,
                         double mu) {
  const Complex centre{0.3, -0.2};
  return {{held_body(Circle{inner}, 128, {centre}, motion),
           enclosing_wall(Circle{outer}, 128, {centre}, {0.0, outer_omega})},
          mu,
          {},
          {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(couette)

// The flow u = A r + B / r has the torque L = 4 pi mu B. The dissipation is the work of both walls.
BOOST_AUTO_TEST_CASE(reference_C6) {
  const StokesProblem problem = concentric(1.0, 2.5, {0.0, 0.4}, -0.7, 1.3);
  for (const ClosureForm form : all_forms) {
    const Completion result = solve_bounded(problem, form);
    const auto& [inner, outer] = std::tie(result.loads[0], result.loads[1]);
    BOOST_TEST(distance(inner, {0.0, 21.392749974444783}) < 1e-12);
    BOOST_TEST(distance(outer, {0.0, -21.392749974444783}) < 1e-12);
    const double dissipation = 0.4 * inner.torque - 0.7 * outer.torque;
    BOOST_TEST(dissipation == 23.532024971889261, boost::test_tools::tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(velocity_profile_C6) {
  const StokesProblem problem = concentric(1.0, 2.5, {0.0, 0.4}, -0.7, 1.3);
  const Eigen::VectorXd solution = solve(assemble_bounded(problem, ClosureForm::reduced));
  const Completion result = complete_dense(problem, ClosureForm::reduced, solution);
  const Complex direction = std::polar(1.0, 0.9);
  const ComplexVector point{{problem.components[0].centre + 1.7 * direction}};
  const std::vector<Curve> curves{problem.components[0].curve, problem.components[1].curve};
  const ComplexVector velocity = StressletSum(curves)(point, deinterleaved(solution)) +
                                 Closure(problem).singular_velocity(result, point);
  // With 128 nodes and a distance of 0.7 from the inner circle, the trapezoid rule's error is about
  // exp(-68).
  BOOST_TEST(std::abs(velocity[0] + 0.77588235294117647 * perp(direction)) < 1e-13);
}

// The closed forms are F (log(R/a) - (R^2 - a^2)/(R^2 + a^2)) = 4 pi mu U and
// L (1/a^2 - 1/R^2) = 4 pi mu omega.
BOOST_AUTO_TEST_CASE(circle_in_a_container) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const double a = 0.8 * scale, radius = 2.1 * scale, mu = 1.3;
    const RigidMotion motion{scale * Complex{0.7, -0.3}, 1.1};
    const double a2 = a * a, r2 = radius * radius;
    const Load exact{4 * pi * mu / (std::log(radius / a) - (r2 - a2) / (r2 + a2)) * motion.velocity,
                     4 * pi * mu / (1 / a2 - 1 / r2) * motion.omega};
    const StokesProblem problem = concentric(a, radius, motion, 0.0, mu);
    const Completion result = solve_bounded(problem, ClosureForm::reduced);
    BOOST_TEST(distance(result.loads[0], exact, scale) < 1e-12 * std::abs(exact.force));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
