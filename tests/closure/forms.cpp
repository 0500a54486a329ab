// Checks that the three forms of the closure are equivalent: the forms give the same motions, loads
// and flow for held and free bodies together, for any right-hand side of a free body's border rows.

#include <boost/test/unit_test.hpp>

#include "double_layer/stresslet_sum.hpp"
#include "support/problems.hpp"

namespace stokesbook::test {
namespace {

// The problem has held and free bodies of several shapes, a background flow, loads and a gauge.
StokesProblem mixed_problem() {
  StokesProblem problem{{free_body(Ellipse{1, 0.6}, 96, {{-2.5, 0.5}, 0.7}, {{1.0, -0.4}, 0.3}),
                         held_body(Circle{0.8}, 64, {{0.3, -1.6}}, {{0.2, 0.5}, -1.0}),
                         free_body(lopsided_curve(), 128, {{1.2, 1.6}, 2.0}, {{-0.6, -0.2}, 0.0}),
                         held_body(Superellipse{0.7, 0.7, 4}, 128, {{3.3, -0.8}, 0.3}, {})},
                        1.3,
                        {},
                        50.0};
  const ComplexVector x = all_nodes(problem);
  problem.background = (0.4 * x.conjugate().array() + Complex{0.3, 0.1}).matrix();
  return problem;
}

// Returns the fluid's velocity away from the bodies (03.4): density, loads and background flow.
ComplexVector flow_at(const StokesProblem& problem, const ComplexVector& points,
                      const ComplexVector& density, const Completion& completion) {
  return StressletSum(curves_of(problem))(points, density) +
         Closure(problem).singular_velocity(completion, points);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(forms)

BOOST_AUTO_TEST_CASE(agree) {
  const StokesProblem problem = mixed_problem();
  const Completion reduced = solve_dense(problem, ClosureForm::reduced);
  for (const ClosureForm form : {ClosureForm::power_bordered, ClosureForm::scaled_bordered}) {
    const Completion bordered = solve_dense(problem, form);
    for (std::size_t k = 0; k < problem.components.size(); ++k) {
      BOOST_TEST(distance(bordered.motions[k], reduced.motions[k]) < 1e-12);
      BOOST_TEST(distance(bordered.loads[k], reduced.loads[k]) < 1e-12);
    }
  }
}

// The densities differ by rigid motions, which produce no flow (03.3).
BOOST_AUTO_TEST_CASE(have_one_flow) {
  const StokesProblem problem = mixed_problem();
  const ComplexVector points{{{-6.0, 2.0}, {0.0, 6.0}, {5.0, 5.0}, {-1.0, -7.0}}};
  std::vector<ComplexVector> flows, densities;
  for (const ClosureForm form : all_forms) {
    const DenseSystem system = assemble(problem, form);
    const Eigen::VectorXd solution = solve(system);
    const Eigen::Index n = all_nodes(problem).size();
    densities.push_back(solution.head(2 * n).reshaped(2, n).transpose() *
                        Eigen::Vector2cd{1.0, imaginary});
    flows.push_back(
        flow_at(problem, points, densities.back(), complete_dense(problem, form, solution)));
  }
  BOOST_TEST((flows[0] - flows[2]).cwiseAbs().maxCoeff() < 1e-12);
  BOOST_TEST((flows[1] - flows[2]).cwiseAbs().maxCoeff() < 1e-12);
  BOOST_TEST((densities[0] - densities[2]).cwiseAbs().maxCoeff() > 1e-3);
}

BOOST_AUTO_TEST_CASE(border_of_free_bodies_may_hold_anything) {
  const StokesProblem problem{{free_body(Ellipse{1, 0.6}, 64, {{-1.5, 0.5}, 0.7}, {{1, -0.4}, 0.3}),
                               free_body(Circle{0.8}, 64, {{1.4, 0}}, {{-1, 0.4}, 0.0})},
                              1.0,
                              {},
                              {}};
  for (const ClosureForm form : {ClosureForm::power_bordered, ClosureForm::scaled_bordered}) {
    DenseSystem system = assemble(problem, form);
    const Completion given = complete_dense(problem, form, solve(system));
    system.rhs.tail(6) << 1.0, -2.0, 0.5, 0.0, 3.0, -0.7;
    const Completion other = complete_dense(problem, form, solve(system));
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(distance(given.motions[k], other.motions[k]) < 1e-13);
    }
  }
}

// If all data are multiplied by -2, the solution must be multiplied by -2.
BOOST_AUTO_TEST_CASE(right_hand_side_and_system_are_linear) {
  const StokesProblem problem = mixed_problem();
  const Completion once = solve_dense(problem, ClosureForm::reduced);
  StokesProblem doubled = problem;
  doubled.background *= -2.0;
  for (Component& component : doubled.components) {
    component.force *= -2.0;
    component.torque *= -2.0;
    component.velocity *= -2.0;
  }
  const Completion twice = solve_dense(doubled, ClosureForm::reduced);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    BOOST_TEST(distance(twice.motions[k],
                        {-2.0 * once.motions[k].velocity, -2.0 * once.motions[k].omega}) < 1e-13);
    BOOST_TEST(distance(twice.loads[k], {-2.0 * once.loads[k].force, -2.0 * once.loads[k].torque}) <
               1e-12);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
