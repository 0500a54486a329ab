// Checks that three numbers agree (07.11): the power of the tractions on the boundary, the power of
// motions and loads, and the fluid's dissipation. Compares the numbers with closed forms.
#include "stress/dissipation.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "stress/traction.hpp"
#include "support/eccentric_annulus.hpp"
#include "support/exact_flows.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

double sum(const std::vector<double>& terms) {
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

struct Dissipation {
  explicit Dissipation(const SolvedFlow& flow) {
    const StokesProblem& problem = flow.problem();
    const ComplexVector traction = boundary_traction(problem, flow.derivatives(flow.nodes()));
    by_boundary = sum(boundary_power(flow, traction));
    by_loads = sum(power_of_loads(flow));
    const FluidQuadrature rule = fluid_quadrature(curves_of(problem), 14.0);
    by_volume = volume_dissipation(rule, flow.derivatives(rule.points), problem.viscosity);
  }

  double by_boundary, by_loads, by_volume;
};

void check_agreement(const Dissipation& d) {
  BOOST_TEST(std::abs(d.by_boundary - d.by_loads) < 1e-12 * d.by_loads);
  BOOST_TEST(std::abs(d.by_volume - d.by_loads) < 1e-9 * d.by_loads);
}

}  // namespace

BOOST_AUTO_TEST_CASE(couette_C6) {
  for (double scale : {1.0, 1e-3}) {
    BOOST_TEST_CONTEXT("scale " << scale) {
      const StokesProblem problem{{test::held_body(Circle{scale}, 96, {}, {0.0, 0.4}),
                                   test::enclosing_wall(Circle{2.5 * scale}, 96, {}, {0.0, -0.7})},
                                  1.3,
                                  {},
                                  {}};
      const Dissipation d(test::solve_flow(problem));
      check_agreement(d);
      const double exact = 23.532024971889261 * scale * scale;
      BOOST_TEST(std::abs(d.by_loads - exact) < 1e-12 * exact);
    }
  }
}

BOOST_AUTO_TEST_CASE(eccentric_annulus) {
  const double mu = 1.3;
  const test::EccentricAnnulus annulus{
      1.0, 2.0, {0.1, -0.2}, {0.4, 0.2}, {{0.3, -0.4}, 1.0}, {{0.1, 0.2}, -0.5}};
  const Dissipation d(test::solve_flow(test::annulus_problem(annulus, mu, 128, 128)));
  check_agreement(d);
  const Load inner = test::inner_load(annulus, mu);
  const Complex relative = annulus.inner.velocity - annulus.outer.velocity;
  const Complex arm = annulus.inner_centre - annulus.outer_centre;
  const double exact = dot(relative, inner.force) + annulus.inner.omega * inner.torque -
                       annulus.outer.omega * (inner.torque + cross(arm, inner.force));
  BOOST_TEST(std::abs(d.by_loads - exact) < 1e-12 * exact);
}

// Free bodies with loads and a held body lie in a container whose wall deforms.
BOOST_AUTO_TEST_CASE(several_bodies_in_a_deforming_container) {
  Component wall = test::enclosing_wall(Ellipse{4.0, 3.0}, 160, {});
  wall.velocity = 0.5 * wall.curve.x.conjugate() + (0.3 * imaginary) * wall.curve.x;
  const StokesProblem problem{
      {test::free_body(Ellipse{1.0, 0.5}, 128, {{-1.3, 0.3}, 0.7}, {{1.0, -2.0}, 0.5}),
       test::free_body(Superellipse{0.8, 0.6, 4}, 224, {{1.4, -0.6}, 0.2}),
       test::held_body(Circle{0.5}, 80, {{0.6, 1.5}}, {{0.2, 0.1}, -1.0}), wall},
      1.3,
      {},
      {}};
  const Dissipation d(test::solve_flow(problem));
  check_agreement(d);
  BOOST_TEST(d.by_loads > 0.0);
}

// The forces on the bodies in the unbounded fluid have the sum zero. The work of the loads is the
// energy that the fluid dissipates.
BOOST_AUTO_TEST_CASE(bodies_in_an_unbounded_fluid) {
  const StokesProblem problem{
      {test::free_body(Ellipse{1.0, 0.5}, 160, {{-1.3, 0.3}, 0.7}, {{1.0, -2.0}, 0.5}),
       test::free_body(Circle{0.8}, 160, {{1.0, 0.4}}, {{-1.0, 2.0}, 0.3})},
      1.3,
      {},
      {}};
  const SolvedFlow flow = test::solve_flow(problem);
  const ComplexVector traction = boundary_traction(problem, flow.derivatives(flow.nodes()));
  const std::vector<double> by_boundary = boundary_power(flow, traction);
  const std::vector<double> by_loads = power_of_loads(flow);
  for (std::size_t k : {0U, 1U}) {
    BOOST_TEST(std::abs(by_boundary[k] - by_loads[k]) < 1e-12 * std::abs(sum(by_loads)));
  }
  BOOST_TEST(sum(by_loads) > 0.0);
}
