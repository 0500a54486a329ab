// Check of exercise 07.3: pseudo-tractions by differences of velocities, their torques and powers;
// diagnoses.
#include "chapters/check.hpp"

#include <numbers>

#include "stress/dissipation.hpp"
#include "stress/stress.hpp"
#include "stress/traction.hpp"
#include "support/eccentric_annulus.hpp"
#include "support/exact_flows.hpp"
#include "support/finite_differences.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

Complex pseudo(const FlowDerivatives& flow, Complex n, double viscosity);
double torque_difference(double omega, double area, double viscosity);
double unnoticed(double inner_radius, double outer_radius, double omega);
std::string diagnose(const SolvedFlow& flow, const ComplexVector& traction);

namespace {

constexpr double viscosity = 1.3;

void check_pseudo(Complex z, Complex n) {
  const test::ExactFlow flow{{{{0.3, -0.2}, {0.5, 0.8}, 0.4}}, 0.7};
  const FlowDerivatives at{flow.pressure(z), flow.vorticity(z), flow.strain(z)};
  const auto velocity = [&](Complex point) { return flow.velocity(point); };
  const Complex exact = viscosity * (test::derivative(velocity, z, n) - flow.pressure(z) * n);
  const Complex strain_only = viscosity * (0.5 * at.strain * std::conj(n) - at.pressure * n);
  expect(
      {.what = "at z = " + exercise::text(z) + ", n = " + exercise::text(n),
       .got = pseudo(at, n, viscosity),
       .expected = exact,
       .tolerance = 1e-9,
       .mistakes = {{traction(at, n, viscosity), "this is the traction: only du/dn is asked for"},
                    {strain_only, "the vorticity turns the velocity along n: i w n/2 is missing"},
                    {2.0 * strain_only - exact, "the vorticity has the other sign"}}});
}

// The reader's pseudo-traction is not needed: by definition, from exact derivatives.
ComplexVector pseudo_tractions(const SolvedFlow& flow) {
  const std::vector<FlowDerivatives> at = flow.derivatives(flow.nodes());
  ComplexVector result = boundary_traction(flow.problem(), at);
  Index i = 0;
  for (const Component& component : flow.problem().components) {
    for (const Complex n : normals(component.curve)) {
      const FlowDerivatives& here = at[static_cast<std::size_t>(i)];
      // Minus (grad u)^T n.
      result[i++] -= flow.problem().viscosity * 0.5 *
                     (here.strain * std::conj(n) - imaginary * here.vorticity * n);
    }
  }
  return result;
}

// A loaded body that turns, and a free one.
SolvedFlow loaded(const Shape& shape, const Load& load) {
  return test::solve_flow({{test::free_body(shape, 128, {{-1.0, 0.2}, 0.4}, load),
                            test::free_body(Circle{0.5}, 96, {{1.1, 0.0}}, {-load.force, 0.2})},
                           viscosity,
                           {},
                           {}});
}

void check_torque(const Shape& shape) {
  const SolvedFlow flow = loaded(shape, {{0.5, 1.0}, 2.0});
  const double omega = flow.completion().motions[0].omega;
  const double size = area(flow.problem().components[0].curve);
  const double exact = integrated_loads(flow.problem(), pseudo_tractions(flow))[0].torque -
                       flow.completion().loads[0].torque;
  expect({.what = "omega = " + exercise::text(omega) + ", A = " + exercise::text(size),
          .got = torque_difference(omega, size, viscosity),
          .expected = exact,
          .tolerance = 1e-8,
          .mistakes = {{-exact, "n points into the body"},
                       {0.5 * exact, "the moment of x is twice the area"},
                       {exact / viscosity, "the viscosity is missing"}}});
}

double power(const SolvedFlow& flow, const ComplexVector& traction) {
  double sum = 0.0;
  for (const double part : boundary_power(flow, traction)) sum += part;
  return sum;
}

void check_unnoticed(double inner, double outer, double omega) {
  const double other = unnoticed(inner, outer, omega);
  const std::string what = "radii " + exercise::text(inner) + " and " + exercise::text(outer);
  if (!(std::abs(other) > 1e-3 * std::abs(omega))) {
    throw exercise::Rejection{exercise::line("for", what) +
                              exercise::line("mistake", "not zero, or next to it, was asked for")};
  }
  const test::EccentricAnnulus annulus{inner,        outer,       {}, {0.3 * (outer - inner), 0.0},
                                       {0.0, omega}, {0.0, other}};
  const SolvedFlow flow = test::solve_flow(test::annulus_problem(annulus, viscosity, 96, 96));
  const double right =
      power(flow, boundary_traction(flow.problem(), flow.derivatives(flow.nodes())));
  expect({.what = what + ", the power by pseudo-tractions",
          .got = power(flow, pseudo_tractions(flow)),
          .expected = right,
          .tolerance = 1e-9,
          .mistakes = {{right + 2.0 * viscosity * pi *
                                    (other * other * outer * outer - omega * omega * inner * inner),
                        "the angular velocity enters as its square: omega_1^2 R_1^2 = omega_2^2 "
                        "R_2^2"}}});
}

struct Disguise {
  std::string name;
  ComplexVector (*traction)(const SolvedFlow&);
};

ComplexVector right_tractions(const SolvedFlow& flow) {
  return boundary_traction(flow.problem(), flow.derivatives(flow.nodes()));
}

// Tractions of changed derivatives.
template <class Change>
ComplexVector changed(const SolvedFlow& flow, const Change& change) {
  std::vector<FlowDerivatives> at = flow.derivatives(flow.nodes());
  for (FlowDerivatives& here : at) change(here);
  return boundary_traction(flow.problem(), at);
}

const std::vector<Disguise> disguises{
    {"right", right_tractions},
    {"pseudo", pseudo_tractions},
    {"pressureless",
     [](const SolvedFlow& flow) {
       return changed(flow, [](FlowDerivatives& at) { at.pressure = 0.0; });
     }},
    {"reversed", [](const SolvedFlow& flow) -> ComplexVector { return -right_tractions(flow); }},
    {"tilted", [](const SolvedFlow& flow) {
       return changed(flow, [](FlowDerivatives& at) { at.strain = std::conj(at.strain); });
     }}};

void check_diagnosis(const Shape& shape, const Load& load) {
  const SolvedFlow flow = loaded(shape, load);
  for (const Disguise& disguise : disguises) {
    const std::string got = diagnose(flow, disguise.traction(flow));
    if (got == disguise.name) continue;
    throw exercise::Rejection{
        exercise::line("got", got) + exercise::line("expected", disguise.name) +
        exercise::line("mistake", "found " + got + ", but it was " + disguise.name)};
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the pseudo-traction",
                         .formula = "-p n + mu/2 (q conj(n) + i w n)",
                         .hint = "du/dn = n du/dz + conj(n) du/d(conj z)",
                         .check =
                             [] {
                               check_pseudo({1.1, -0.7}, std::polar(1.0, 0.4));
                               check_pseudo({-0.9, 0.8}, imaginary);
                             }},
                        {.title = "the torque",
                         .formula = "-2 mu omega A",
                         .hint = "the moment of (grad u)^T n, for the rigid motion",
                         .check =
                             [] {
                               check_torque(Ellipse{0.8, 0.5});
                               check_torque(Circle{0.6});
                             }},
                        {.title = "the defect that hides",
                         .formula = "omega_1^2 R_1^2 = omega_2^2 R_2^2",
                         .hint = "the differences of both powers have opposite signs",
                         .check =
                             [] {
                               check_unnoticed(1.0, 2.0, 1.0);
                               check_unnoticed(0.4, 1.5, -0.7);
                             }},
                        {.title = "the diagnosis",
                         .formula = "loads of completion() against integrated_loads()",
                         .hint = "force, then torque, then the part across n",
                         .check = [] {
                           check_diagnosis(Ellipse{0.8, 0.5}, {{0.5, 1.0}, 2.0});
                           check_diagnosis(Ellipse{0.9, 0.4}, {{-1.0, 0.2}, -1.0});
                         }}});
}
