// Checks that tractions integrate to forces and torques, both given and solved, at any viscosity
// and unit of length. Compares the tractions of disks and the pressure between circles with closed
// forms.
#include "stress/traction.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "support/eccentric_annulus.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using Eigen::Index;
using std::numbers::pi;

namespace {

// Returns the largest difference of integrated and given loads relative to the largest load, with
// torques divided by a length.
double load_error(const SolvedFlow& flow, double length) {
  const StokesProblem& problem = flow.problem();
  const std::vector<Load> found =
      integrated_loads(problem, boundary_traction(problem, flow.derivatives(flow.nodes())));
  return test::relative_distance(found, flow.completion().loads, length);
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_body_in_an_unbounded_fluid) {
  for (double scale : {1.0, 1e-3, 1e3}) {
    for (const Shape& shape : {Shape{Circle{scale}}, Shape{Ellipse{scale, 0.5 * scale}},
                               Shape{test::lopsided_curve(scale)}}) {
      StokesProblem problem{{test::free_body(shape, 128, {scale * Complex{0.3, 0.2}, 0.4},
                                             {{1.0, 0.5}, 0.7 * scale})},
                            1.3,
                            {},
                            scale};
      BOOST_TEST(load_error(test::solve_flow(problem), scale) < 1e-12);
    }
  }
}

// The traction of a disk is F / (2 pi a) under a force F, and L x^perp / (2 pi a^3) under a torque
// L.
BOOST_AUTO_TEST_CASE(pulled_and_turned_disk) {
  for (double radius : {0.7, 1e-3, 1e3}) {
    const Load load{{1.0, 0.5}, 0.7 * radius};
    const Complex centre = radius * Complex{0.3, -2.0};
    const SolvedFlow flow =
        test::solve_flow({{test::free_body(Circle{radius}, 64, {centre}, load)}, 1.3, {}, radius});
    const ComplexVector found = boundary_traction(flow.problem(), flow.derivatives(flow.nodes()));
    const double unit = 1.0 / (2.0 * pi * radius);
    for (Index j = 0; j < found.size(); ++j) {
      const Complex arm = flow.nodes()[j] - centre;
      const Complex exact = unit * (load.force + load.torque * perp(arm) / (radius * radius));
      BOOST_TEST(std::abs(found[j] - exact) < 1e-12 * unit);
    }
  }
}

BOOST_AUTO_TEST_CASE(close_bodies_in_a_container) {
  for (double scale : {1.0, 1e-3}) {
    const auto at = [&](double x, double y) { return scale * Complex{x, y}; };
    const StokesProblem problem{
        {test::free_body(Circle{scale}, 144, {at(-1.0, 0.3)}, {{1.0, -2.0}, 0.5 * scale}),
         test::free_body(Ellipse{scale, 0.6 * scale}, 144, {at(1.1, 0.3), 0.1}),
         test::held_body(Circle{0.5 * scale}, 96, {at(0.0, -1.2)}, {at(0.2, 0.1), -1.0}),
         test::enclosing_wall(Circle{3.0 * scale}, 128, {at(0.2, 0.1)}, {0.0, 0.4})},
        1.3,
        {},
        {}};
    BOOST_TEST(load_error(test::solve_flow(problem), scale) < 1e-12);
  }
}

// Held bodies move among free bodies without a wall: a uniform velocity at infinity balances
// forces.
BOOST_AUTO_TEST_CASE(held_and_free_bodies_in_an_unbounded_fluid) {
  const StokesProblem problem{
      {test::held_body(Ellipse{1.0, 0.7}, 160, {{-1.3, 0.0}, 0.3}, {{1.0, 0.0}, 0.5}),
       test::free_body(Circle{0.9}, 160, {{1.0, 0.5}}, {{0.3, 0.4}, 1.0})},
      1.3,
      {},
      {}};
  BOOST_TEST(load_error(test::solve_flow(problem), 1.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(eccentric_annulus_C7) {
  const test::EccentricAnnulus annulus{1, 2, 0.0, {0, 0.5}, {0.0, 1}, {}};
  const SolvedFlow flow = test::solve_flow(test::annulus_problem(annulus, 1.0, 160, 160));
  const std::vector<Load> loads = integrated_loads(
      flow.problem(), boundary_traction(flow.problem(), flow.derivatives(flow.nodes())));
  BOOST_TEST(test::distance(loads[0], {-13.83366424161095, 20.023919863023254}) < 1e-11);
}

// The Couette flow u = A r + B / r has a constant pressure.
BOOST_AUTO_TEST_CASE(couette_pressure) {
  const StokesProblem problem{{test::held_body(Circle{1.0}, 96, {}, {0.0, 0.4}),
                               test::enclosing_wall(Circle{2.5}, 96, {}, {0.0, -0.7})},
                              1.3,
                              {},
                              {}};
  const SolvedFlow flow = test::solve_flow(problem);
  const double b = 1.1 * 6.25 / 5.25, a = (-0.7 * 6.25 - 0.4) / 5.25;
  ComplexVector targets(96 * 2 + 2);
  targets << flow.nodes(), Complex{1.3, 0.9}, Complex{-1.0 - 1e-7, 0.0};
  const std::vector<FlowDerivatives> at = flow.derivatives(targets);
  for (Index i = 0; i < targets.size(); ++i) {
    const FlowDerivatives& found = at[static_cast<std::size_t>(i)];
    const Complex direction = targets[i] / std::abs(targets[i]);
    const Complex strain = -2.0 * imaginary * b / std::norm(targets[i]) * direction * direction;
    BOOST_TEST(std::abs(found.pressure - at[0].pressure) < 1e-12);
    BOOST_TEST(std::abs(found.vorticity - 2.0 * a) < 1e-11);
    BOOST_TEST(std::abs(found.strain - strain) < 1e-11);
  }
}
