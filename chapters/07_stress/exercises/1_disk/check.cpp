// Check of exercise 07.1: tractions and stresslets from solved densities.
#include "chapters/check.hpp"

#include <numbers>

#include "stress/stresslet.hpp"
#include "stress/traction.hpp"
#include "support/exact_derivatives.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

FlowDerivatives derivatives(Complex z, Complex dphi, Complex ddphi, Complex dpsi);
Complex pulled(double radius, Complex force, Complex point);
Complex turned(double radius, double torque, Complex point);
Complex strained(double radius, Complex strain, double viscosity, Complex point);
Complex stresslet(const Curve& curve, const ComplexVector& density, double viscosity);

namespace {

constexpr double viscosity = 1.3;
constexpr Eigen::Index nodes = 32;

ComplexVector numbers(const FlowDerivatives& flow) {
  return ComplexVector{{flow.pressure, flow.vorticity, flow.strain}};
}

// The flow phi = a / (z - z_0), psi = m / (z - z_0) - conj(z_0) phi': an exact flow of the tests.
void check_derivatives(Complex z) {
  const test::Pole pole{{0.3, -0.2}, {0.5, 0.8}, 0.4};
  const test::ExactFlow flow{{pole}};
  const Complex r = z - pole.at, a = pole.dipole;
  const Complex dphi = -a / (r * r), ddphi = 2.0 * a / (r * r * r);
  // u = a/r + r conj(a/r^2) + m/conj(r), hence psi = conj(z_0) a/r^2 - m/r.
  const Complex dpsi = -2.0 * std::conj(pole.at) * a / (r * r * r) + pole.source / (r * r);
  const FlowDerivatives exact = test::derivatives_of(flow, z);
  FlowDerivatives conjugate = exact, sign = exact, half = exact;
  conjugate.strain = std::conj(exact.strain);
  sign.pressure *= -1.0;
  half.strain *= 0.5;
  expect({.what = "a pole, at z = " + exercise::text(z),
          .got = numbers(derivatives(z, dphi, ddphi, dpsi)),
          .expected = numbers(exact),
          .tolerance = 1e-12,
          .mistakes = {{numbers(conjugate),
                        "the strain must be conjugate: d/d(conj z) of "
                        "conj(psi) is conj(psi')"},
                       {numbers(sign), "the pressure has the other sign"},
                       {numbers(half), "q is twice the derivative"}}});
}

SolvedFlow solve(double radius, const Load& load, Complex strain) {
  StokesProblem problem{{test::free_body(Circle{radius}, nodes, {}, load)}, viscosity, {}, radius};
  problem.background = 0.5 * strain * problem.components[0].curve.x.conjugate();
  return test::solve_flow(problem);
}

// Tractions of the whole flow at the nodes.
ComplexVector tractions(const SolvedFlow& flow, Complex strain) {
  std::vector<FlowDerivatives> at = flow.derivatives(flow.nodes());
  for (FlowDerivatives& here : at) here += {0.0, 0.0, strain};
  return boundary_traction(flow.problem(), at);
}

template <class Traction>
ComplexVector at_nodes(const SolvedFlow& flow, const Traction& traction) {
  return flow.nodes().unaryExpr(traction);
}

void check_pulled(double radius) {
  const Complex force{1.0, -0.4};
  const SolvedFlow flow = solve(radius, {force, 0.0}, 0.0);
  const ComplexVector exact = tractions(flow, 0.0);
  expect({.what = "radius " + exercise::text(radius) + ", F = " + exercise::text(force),
          .got = at_nodes(flow, [&](Complex z) { return pulled(radius, force, z); }),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{-exact, "the normal points into the disk: its force is that on the fluid"},
                       {at_nodes(flow,
                                 [&](Complex z) {
                                   return dot(force, z) * z / (2.0 * pi * std::pow(radius, 3));
                                 }),
                        "this is the pressure's part: the drag along the surface is missing"},
                       {radius * exact, "the radius is missing: the integral must be F"}}});
}

void check_turned(double radius) {
  const double torque = 0.7;
  const SolvedFlow flow = solve(radius, {0.0, torque}, 0.0);
  const ComplexVector exact = tractions(flow, 0.0);
  expect({.what = "radius " + exercise::text(radius) + ", L = " + exercise::text(torque),
          .got = at_nodes(flow, [&](Complex z) { return turned(radius, torque, z); }),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{radius * exact, "the torque is an integral of force times radius"},
                       {-exact, "counter-clockwise torques are positive"}}});
}

void check_strained(double radius) {
  const Complex strain{0.8, -1.1};
  const SolvedFlow flow = solve(radius, {}, strain);
  const ComplexVector exact = tractions(flow, strain);
  expect({.what = "radius " + exercise::text(radius) + ", q = " + exercise::text(strain),
          .got = at_nodes(flow, [&](Complex z) { return strained(radius, strain, viscosity, z); }),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{0.5 * exact, "this is the stress of the flow without the disk"},
                       {radius * exact, "the normal has length 1"},
                       {-exact, "the normal points into the disk"}}});
}

void check_stresslet(const Shape& shape, const std::string& name) {
  const Complex strain{0.8, -1.1};
  StokesProblem problem{{test::free_body(shape, 128, {0.2, 0.5})}, viscosity, {}, {}};
  const Curve& curve = problem.components[0].curve;
  problem.background = 0.5 * strain * curve.x.conjugate();
  const ComplexVector density = test::solve_flow(problem).density();
  const Complex exact = body_stresslet(curve, density, viscosity);
  const Complex conjugate = -viscosity * density.dot(normals(curve).cwiseProduct(weights(curve)));
  expect({.what = name,
          .got = stresslet(curve, density, viscosity),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{0.0,
                        "n eta is the product of complex numbers: the scalar one integrates to the "
                        "flux, which is zero"},
                       {conjugate, "n eta is the product of complex numbers, without a conjugate"},
                       {0.5 * exact, "twice as much: n eta + eta n counts both orders"},
                       {-exact, "the sign is the other one: n points into the body"},
                       {exact / viscosity, "the viscosity is missing"}}});
}

std::function<void()> for_radii(void (*check)(double)) {
  return [check] {
    for (double radius : {1.0, 0.3}) check(radius);
  };
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the derivatives",
        .formula = "p/mu = -4 Re phi', w = 4 Im phi', q = -2 conj(psi' + conj(z) phi'')",
        .hint = "differentiate phi - z conj(phi') - conj(psi) by conj(z)",
        .check =
            [] {
              check_derivatives({1.5, 0.7});
              check_derivatives({-0.4, 0.9});
            }},
       {.title = "the pulled disk",
        .formula = "sigma n = F / (2 pi a)",
        .hint = "the pressure pushes with (F.n)n/(2 pi a); what does the vorticity add?",
        .check = for_radii(check_pulled)},
       {.title = "the turned disk",
        .formula = "sigma n = L z^perp / (2 pi a^3)",
        .hint = "it is tangential, and its moment is L",
        .check = for_radii(check_turned)},
       {.title = "the strained disk",
        .formula = "sigma n = -2 mu q conj(z) / a, twice that of the flow alone",
        .hint = "its dipole must be the stresslet 2 pi mu a^2 q",
        .check = for_radii(check_strained)},
       {.title = "the stresslet",
        .formula = "S11 + i S12 = -mu int n eta ds",
        .hint = "normals() and weights() are all that is needed",
        .check = [] {
          check_stresslet(Circle{0.8}, "a disk");
          check_stresslet(Ellipse{1.0, 0.5}, "an ellipse");
        }}});
}
