// Check of exercise 03.3: closed forms, condition numbers, and forces that balance.
#include "chapters/check.hpp"

#include <numbers>

#include "support/problems.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

double drag(double radius, double viscosity, double gauge);
double degenerate_gauge(const Ellipse& ellipse);
double breaking_gauge(const Ellipse& ellipse, double wanted);
StokesProblem repaired(StokesProblem problem);

namespace {

constexpr int nodes = 40;

Component held(const Shape& shape, Complex centre, Complex velocity) {
  const Curve curve = place(sample(shape, nodes, Side::fluid_outside), centre, 0.0);
  return {
      ComponentKind::prescribed, curve, centre, 0.0, 0.0, ComplexVector::Constant(nodes, velocity)};
}

}  // namespace

StokesProblem held_ellipse(const Ellipse& ellipse, double gauge) {
  return {{held(ellipse, {0.4, -0.2}, {1.0, 0.5})}, 1.0, {}, gauge};
}

double condition(const StokesProblem& problem) {
  const Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  const auto norm = [](const Eigen::MatrixXd& a) {
    return a.cwiseAbs().rowwise().sum().maxCoeff();
  };
  return norm(matrix) * norm(test::inverse(matrix));
}

Completion solve(const StokesProblem& problem) {
  return test::solve_dense(problem, ClosureForm::reduced);
}

namespace {

void check_drag(double radius, double gauge) {
  constexpr double mu = 1.3;
  const Complex velocity{0.6, -0.8};  // of the length 1
  const StokesProblem problem{{held(Circle{radius}, 0.0, velocity)}, mu, {}, gauge};
  const double exact = dot(solve(problem).loads[0].force, velocity);
  expect({.what = "radius " + exercise::text(radius) + ", gauge length " + exercise::text(gauge),
          .got = drag(radius, mu, gauge),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{-4.0 * pi * mu / std::log(radius / gauge),
                        "the 1/2 is missing, of the terms beside the logarithm"},
                       {-exact, "this is the force of the fluid on the circle"},
                       {exact / mu, "the viscosity is missing"},
                       {exact / (4.0 * pi), "the factor 4 pi is missing"}}});
}

// The velocity along an axis of a free ellipse under a unit force along it, times 4 pi mu: the
// logarithm of the gauge length is all that depends on the gauge.
double velocity_along(const Ellipse& ellipse, Complex axis) {
  StokesProblem problem = held_ellipse(ellipse, 1.0);
  problem.components[0].kind = ComponentKind::free_body;
  problem.components[0].force = axis;
  problem.components[0].velocity = {};  // no slip
  return 4.0 * pi * dot(solve(problem).motions[0].velocity, axis);
}

void check_degenerate(const Ellipse& e) {
  const double across = std::exp(-velocity_along(e, imaginary));
  const double along = std::exp(-velocity_along(e, 1.0));
  const double mean = 0.5 * (e.a + e.b);
  expect(
      {.what = "a = " + exercise::text(e.a) + ", b = " + exercise::text(e.b),
       .got = degenerate_gauge(e),
       .expected = across,
       .tolerance = 1e-6,
       .mistakes = {{along, "this is the smaller one, for forces along the major axis"},
                    {mean * mean / across,
                     "the exponent has the other sign: the gauge is smaller than the body"},
                    {mean / std::sqrt(std::numbers::e), "this is a circle of the same mean radius"},
                    {mean, "this is the mean radius: the 1/2 of the circle has a counterpart"}}});
}

void check_breaking(const Ellipse& e, double wanted) {
  // In decades: 20 per cent are 0.08 of one.
  const auto decades = [&](double gauge) { return std::log10(condition(held_ellipse(e, gauge))); };
  const double degenerate = std::exp(-velocity_along(e, imaginary));
  const double gauge = breaking_gauge(e, wanted);
  expect({.what = "decades of the condition number, wanted " + exercise::text(wanted),
          .got = decades(gauge),
          .expected = std::log10(wanted),
          .tolerance = 0.08 / std::log10(wanted),
          .mistakes = {{decades(degenerate * (1.0 + 1.0 / wanted)),
                        "this takes 1 for the constant: measure it at some small distance"},
                       {std::log10(condition(held_ellipse(e, degenerate_gauge(e)))),
                        "this is the degenerate gauge itself, up to rounding; keep some distance"},
                       {decades(0.5 * (e.a + e.b)), "this is far from the degenerate gauge"}}});
}

// Two circles, one held and one drawn away, in a unit of length.
StokesProblem two_circles(double length, double gauge) {
  return {{held(Circle{length}, 0.0, 0.0),
           held(Circle{0.7 * length}, Complex{2.5 * length, 0.0}, {1.0, 0.3})},
          1.0,
          {},
          gauge};
}

Eigen::VectorXcd forces(const StokesProblem& problem) {
  const Completion completion = solve(problem);
  return Eigen::Vector2cd{completion.loads[0].force, completion.loads[1].force};
}

void check_repaired(double length) {
  // Balance: no length is in forces of bodies whose sizes and distances have one ratio.
  const Eigen::VectorXcd got = forces(repaired(two_circles(length, 3.0)));
  expect({.what = "the sum of the forces on two circles of size " + exercise::text(length),
          .got = got.sum(),
          .expected = 0.0,
          .tolerance = 1e-11,
          .mistakes = {{forces(two_circles(length, 1.0)).sum(),
                        "a gauge length of 1 is still one: forces in unbounded fluid must balance"},
                       {forces(two_circles(length, 1e9)).sum(),
                        "the loads still depend on a gauge length, however large: forces in "
                        "unbounded fluid must balance"}}});
  const Completion completion = solve(repaired(two_circles(length, 3.0)));
  expect({.what = "the torque on the first, over that of the unit circle",
          .got = completion.loads[0].torque / length,
          .expected = solve(repaired(two_circles(1.0, 3.0))).loads[0].torque,
          .tolerance = 1e-9});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the drag of a circle",
        .formula = "U = F/(4 pi mu) (1/2 - log(a/l))",
        .hint = "solve for F; near the singularity either sign is right",
        .check =
            [] {
              check_drag(0.7, 20.0);
              check_drag(1.0, 0.5);
            }},
       {.title = "the degenerate gauge",
        .formula = "a/(a+b) - log(R/l) = 0 or b/(a+b) - log(R/l) = 0, R = (a+b)/2",
        .hint = "the exponents are negative, and the larger length has the smaller of them",
        .check =
            [] {
              check_degenerate({1.3, 1.0});
              check_degenerate({1.0, 0.6});
            }},
       {.title = "a condition number as wanted",
        .builds_on = {2},
        .formula = "condition = C / |l/l_0 - 1|",
        .hint = "measure C once at a distance of 1e-3",
        .check =
            [] {
              check_breaking({1.3, 1.0}, 1e6);
              check_breaking({1.0, 0.6}, 1e9);
            }},
       {.title = "the repair",
        .formula = "the forces add up to zero, and the fluid far away moves as it likes",
        .hint = "a problem need not have a gauge length",
        .check = [] {
          for (double length : {1e-3, 1.0, 50.0}) check_repaired(length);
        }}});
}
