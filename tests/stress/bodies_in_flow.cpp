// Checks free bodies in linear flows: stresslets (07.14), (07.15) and surface stress against closed
// forms and reference numbers, the field's equations by finite differences, and jumps across the
// boundary (07.9).
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "stress/stress.hpp"
#include "stress/stresslet.hpp"
#include "stress/traction.hpp"
#include "support/exact_derivatives.hpp"
#include "support/finite_differences.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

using std::numbers::pi;
const FlowDerivatives unit_shear = flow_derivatives({.du1_dx2 = 1.0});
const FlowDerivatives extension = flow_derivatives({.du1_dx1 = 1.0});

SolvedFlow in_linear_flow(std::vector<Component> bodies, double mu, const FlowDerivatives& linear) {
  StokesProblem problem{std::move(bodies), mu, {}, {}};
  problem.background = test::linear_velocity(linear, test::all_nodes(problem));
  return test::solve_flow(problem);
}

// Returns the derivatives of the whole flow, which is the disturbance plus the linear flow.
std::vector<FlowDerivatives> whole(const SolvedFlow& flow, const FlowDerivatives& linear,
                                   const ComplexVector& targets) {
  std::vector<FlowDerivatives> result = flow.derivatives(targets);
  for (FlowDerivatives& at : result) at += linear;
  return result;
}

// Returns the first body's stresslet by the density, and compares it with the stresslet by the
// traction, -(1 / 2) oint (sigma n) (x - c) ds (07.14).
Complex first_stresslet(const SolvedFlow& flow, const FlowDerivatives& linear) {
  const StokesProblem& problem = flow.problem();
  const Component& body = problem.components[0];
  const Index n = body.curve.size();
  const ComplexVector traction = boundary_traction(problem, whole(flow, linear, flow.nodes()));
  const Complex found = body_stresslet(body.curve, flow.density().head(n), problem.viscosity);
  const ComplexVector force = traction.head(n).cwiseProduct(weights(body.curve));
  const Complex again =
      -0.5 * force.cwiseProduct((body.curve.x.array() - body.centre).matrix()).sum();
  BOOST_TEST(std::abs(found - again) < 1e-12 * std::abs(found));
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(stresslet_of_a_circle) {
  for (double scale : {1.0, 1e-3, 1e3}) {
    const double mu = 1.3;
    const SolvedFlow flow =
        in_linear_flow({test::free_body(Circle{scale}, 64, {})}, mu, unit_shear);
    const Complex found = first_stresslet(flow, unit_shear);
    const Complex exact =
        2.0 * pi * mu * scale * scale * unit_shear.strain;  // 4 pi mu a^2 E, q = 2 E
    BOOST_TEST(std::abs(found - exact) < 1e-13 * std::abs(exact));
    const double area = pi * scale * scale;
    BOOST_TEST(std::abs(intrinsic_viscosity(found, unit_shear.strain, area, mu) - 2.0) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(ellipse_C3_and_its_surface_NF) {
  const SolvedFlow flow =
      in_linear_flow({test::free_body(Ellipse{2.0, 1.0}, 128, {0.0, 0.5})}, 1.0, unit_shear);
  BOOST_TEST(std::abs(first_stresslet(flow, unit_shear) -
                      Complex{1.2854889522196489, 13.311763977068673}) < 1e-12);
  const StokesProblem& problem = flow.problem();
  const std::vector<FlowDerivatives> at_nodes = whole(flow, unit_shear, flow.nodes());
  const ComplexVector traction = boundary_traction(problem, at_nodes);
  BOOST_TEST(std::abs(at_nodes[0].pressure + 2.524412954423) < 1e-11);
  BOOST_TEST(std::abs(at_nodes[0].vorticity - 0.296725534084) < 1e-11);
  BOOST_TEST(std::abs(traction[0] - Complex{-1.749118284612, -2.063755827537}) < 1e-11);
  BOOST_TEST(std::abs(at_nodes[32].pressure - 1.262206477212) < 1e-11);
  BOOST_TEST(std::abs(at_nodes[32].vorticity + 1.648362767042) < 1e-11);
  // On a rigid surface that turns with Omega the traction is -p n + mu (w - 2 Omega) t (07.5),
  // (07.8).
  const double omega = flow.completion().motions[0].omega;
  const ComplexVector normal = normals(problem.components[0].curve);
  for (std::size_t j = 0; j < at_nodes.size(); ++j) {
    const Complex n = normal[static_cast<Index>(j)];
    const Complex from_vorticity =
        -at_nodes[j].pressure * n + (at_nodes[j].vorticity - 2.0 * omega) * perp(n);
    BOOST_TEST(std::abs(traction[static_cast<Index>(j)] - from_vorticity) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(lopsided_body_N2) {
  const SolvedFlow flow =
      in_linear_flow({test::free_body(test::lopsided_curve(), 192, {})}, 1.0, unit_shear);
  BOOST_TEST(std::abs(first_stresslet(flow, unit_shear) -
                      Complex{-0.075772533699336, 6.5450393096611492}) < 1e-12);
}

BOOST_AUTO_TEST_CASE(pairs_of_circles_N3) {
  const auto pair = [](double gap) {
    return std::vector<Component>{test::free_body(Circle{1.0}, 144, {{-1.0 - 0.5 * gap}}),
                                  test::free_body(Circle{1.0}, 144, {{1.0 + 0.5 * gap}})};
  };
  BOOST_TEST(
      std::abs(first_stresslet(in_linear_flow(pair(0.5), 1.0, unit_shear), unit_shear).imag() -
               5.50789512251502) < 1e-12);
  BOOST_TEST(
      std::abs(first_stresslet(in_linear_flow(pair(0.1), 1.0, unit_shear), unit_shear).imag() -
               5.69598502258849) < 1e-11);
  BOOST_TEST(std::abs(first_stresslet(in_linear_flow(pair(0.1), 1.0, extension), extension).real() -
                      16.8631930688144) < 1e-11);
}

// A load adds a force and a torque, but nothing to the symmetric dipole about the body's centre.
BOOST_AUTO_TEST_CASE(loads_do_not_enter_the_stresslet) {
  const auto found = [](const Load& load) {
    return first_stresslet(
        in_linear_flow({test::free_body(Circle{0.8}, 128, {{-1.0, 0.2}}, load),
                        test::free_body(Circle{0.8}, 128, {{1.0, 0.0}}, {-load.force, 0.0})},
                       1.3, unit_shear),
        unit_shear);
  };
  const Complex loaded = found({{2.0, 1.0}, 0.7});
  BOOST_TEST(std::abs(loaded - found({})) > 0.01);  // the other body's flow changes both results
}

// Checks the momentum equation, incompressibility, and the velocity gradient between two bodies.
BOOST_AUTO_TEST_CASE(equations_by_finite_differences) {
  const double mu = 1.3;
  const SolvedFlow flow =
      in_linear_flow({test::free_body(Ellipse{1.0, 0.6}, 96, {{-1.2, 0.3}, 0.4}, {{1.0, 0.3}, 0.4}),
                      test::free_body(Circle{0.7}, 96, {{0.9, -0.2}}, {{-1.0, -0.3}, 0.1})},
                     mu, extension);
  const auto velocity = [&](Complex z) {
    const ComplexVector at{{z}};
    return flow.velocity(at)[0] + test::linear_velocity(extension, at)[0];
  };
  const auto at = [&](Complex z) { return whole(flow, extension, ComplexVector{{z}})[0]; };
  const auto row_1 = [&](Complex z) {
    const Stress s = stress(at(z), mu);
    return Complex{s.s11, s.s12};
  };
  const auto row_2 = [&](Complex z) {
    const Stress s = stress(at(z), mu);
    return Complex{s.s12, s.s22};
  };
  for (const Complex z : {Complex{0.0, 0.4}, Complex{-0.9, 1.4}}) {
    BOOST_TEST(std::abs(test::divergence(velocity, z)) < 1e-9);
    BOOST_TEST(std::abs(test::derivative(row_1, z, 1.0).real() +
                        test::derivative(row_1, z, imaginary).imag()) < 1e-8);
    BOOST_TEST(std::abs(test::derivative(row_2, z, 1.0).real() +
                        test::derivative(row_2, z, imaginary).imag()) < 1e-8);
    const VelocityGradient gradient = velocity_gradient(at(z));
    const Complex along_2 = test::derivative(velocity, z, imaginary);
    BOOST_TEST(std::abs(Complex{gradient.du1_dx2, gradient.du2_dx2} - along_2) < 1e-9);
  }
}

// The jumps from the fluid to the other side are [p] = -2 mu t.eta_s, [q] = 2 (t.eta_s) t^2 and [w]
// = -2 n.eta_s, and the traction has no jump (07.9). A curve with the fluid on its other side has
// the opposite normal, so its double layer has the opposite sign.
BOOST_AUTO_TEST_CASE(jumps_across_the_boundary) {
  Curve curve = sample(test::lopsided_curve(), 192, Side::fluid_outside);
  const ComplexVector density =
      (0.3 * curve.x.array().square() - imaginary * curve.x.array().conjugate()).matrix();
  const auto limits = [&](Side side) {
    curve.side = side;
    const CauchyCurve cauchy(curve);
    return cauchy.derivatives(cauchy.derivative_data(cauchy.data(density)), 0, curve.x);
  };
  const std::vector<FlowDerivatives> other = limits(Side::fluid_inside);
  const std::vector<FlowDerivatives> fluid = limits(Side::fluid_outside);
  const ComplexVector n = normals(curve);
  const ComplexVector slope = differentiate(density).array() / curve.dx.cwiseAbs().array();
  for (Index j = 0; j < curve.size(); ++j) {
    const std::size_t i = static_cast<std::size_t>(j);
    const Complex t = perp(n[j]);
    const Complex along = curve.sign() * slope[j];
    BOOST_TEST(std::abs(-other[i].pressure - fluid[i].pressure + 2.0 * dot(t, along)) < 1e-10);
    BOOST_TEST(std::abs(-other[i].strain - fluid[i].strain - 2.0 * dot(t, along) * t * t) < 1e-10);
    BOOST_TEST(std::abs(-other[i].vorticity - fluid[i].vorticity + 2.0 * dot(n[j], along)) < 1e-10);
    BOOST_TEST(std::abs(traction(other[i], n[j], 1.0) + traction(fluid[i], n[j], 1.0)) < 1e-10);
  }
}
