// Check of exercise 04.4: the reader's lines against fluxes and balances.
#include "chapters/check.hpp"

#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

double wall_speed(double inner_radius, double outer_radius, double v);
double invisible_flux(double a, double b);
double net_flux_of_data(const ComplexVector& normals, const ComplexVector& density,
                        const Eigen::VectorXd& weights);
double wall_torque(const ComplexVector& forces, const Eigen::VectorXd& torques,
                   const ComplexVector& centres, Complex about);
double load_rate(double inner_radius, double outer_radius, double e);

namespace {

void check_speed(double inner, double outer, double v) {
  const double inner_flux = 2.0 * pi * inner * v, exact = -inner_flux / (2.0 * pi * outer);
  expect({.what = "r = " + exercise::text(inner) + ", R = " + exercise::text(outer) +
                  ", v = " + exercise::text(v),
          .got = wall_speed(inner, outer, v),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {-v, "the circles have different lengths"},
              {-exact,
               "this is the velocity away from the centre: on the inner circle the normal "
               "points to the centre"},
              {-v * outer / inner, "the lengths are exchanged"},
              {exact * inner / outer, "these are the areas: the flux goes through the lengths"}}});
}

void check_invisible(double a, double b) {
  const Curve wall = sample(Ellipse{a, b}, 32, Side::fluid_inside);
  const double exact = weights(wall).dot(wall.dx.cwiseAbs());
  expect(
      {.what = "a = " + exercise::text(a) + ", b = " + exercise::text(b),
       .got = invisible_flux(a, b),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{2.0 * pi * a * b, "this is right on a circle only: integrate |x'|^2 over t"},
                    {2.0 * exact, "the mean of a squared sine is one half"},
                    {exact / (2.0 * pi), "this is the mean over t: the length 2 pi is missing"},
                    {perimeter(wall), "this is the flux of n: the factor |x'| is missing"}}});
}

// A circular wall, on which (-1/2 + D + N_0) eta is known mode by mode: N_0 n = -n, and
// D eta = -eta_0/2 + conj(eta_1) exp(it)/2.
void check_flux(double radius, double growth) {
  constexpr Eigen::Index nodes = 16;
  const Curve wall = sample(Circle{radius}, nodes, Side::fluid_inside);
  const ComplexVector normal = normals(wall);
  const Eigen::VectorXd weight = weights(wall);
  const Complex mean{0.4, -0.3}, first{growth, 0.6}, third{0.2, 0.9};
  const ComplexVector cubes = normal.array().cube();
  const ComplexVector density = mean + first * normal.array() + third * cubes.array();
  const Complex layer = 0.5 * std::conj(first) - 0.5 * first, n0 = -growth;
  const ComplexVector data = -mean + (layer + n0) * normal.array() - 0.5 * third * cubes.array();
  double exact = 0.0, unweighted = 0.0;
  for (Eigen::Index j = 0; j < nodes; ++j) {
    exact += weight[j] * dot(normal[j], data[j]);
    unweighted -= dot(normal[j], density[j]);
  }
  expect({.what = "circular wall of radius " + exercise::text(radius),
          .got = net_flux_of_data(normal, density, weight),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{-exact, "the flux of the density is -Q"},
                       {exact / perimeter(wall), "this is divided by the length of the wall"},
                       {unweighted, "the weights are missing"}}});
}

void check_torque(double first, Complex about) {
  const ComplexVector forces{{Complex{0.5, -1.0}, Complex{-0.3, 0.2}}};
  const ComplexVector centres{{Complex{0.8, 0.1}, Complex{-0.6, 0.7}}};
  const Eigen::VectorXd torques{{first, -0.9}};
  // About the origin, all torques add up to zero. The force of the wall is minus all others.
  double total = torques.sum();
  for (Eigen::Index k = 0; k < 2; ++k) total += cross(centres[k], forces[k]);
  const double exact = -total - cross(about, -forces.sum());
  const double alone = -torques.sum();
  expect({.what = "two bodies, L_1 = " + exercise::text(first) + ", about " + exercise::text(about),
          .got = wall_torque(forces, torques, centres, about),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {alone, "the forces have torques too: add arm cross force"},
              {-exact, "this is the torque of the bodies: that of the wall balances it"},
              {2.0 * alone - exact, "the arms have the other direction: from c to the bodies"},
              {-total, "these arms begin at the origin, and not at c"}}});
}

void check_rate(double inner, double outer, double e) {
  // The gap between the circles in bipolar coordinates, by the half angle.
  const double gap = outer - inner;
  const double tau = 2.0 * std::asinh(std::sqrt((gap * gap - e * e) / (4.0 * inner * outer)));
  const double once = std::log(outer) - std::log(inner + e);
  const double exact = std::min(2.0 * once, tau);
  expect({.what = "R_1 = " + exercise::text(inner) + ", R_2 = " + exercise::text(outer) +
                  ", e = " + exercise::text(e),
          .got = load_rate(inner, outer, e),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{std::min(once, tau),
                        "this is the rate of the density's alias: a load needs two of them"},
                       {std::max(2.0 * once, tau),
                        "the larger rate belongs to the smaller error, which does not count"},
                       {tau, "this is the second candidate alone"},
                       {2.0 * once, "this is the first candidate alone"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "data without a net flux",
                         .formula = "2 pi r v + 2 pi R w = 0",
                         .hint = "both velocities are given along n, out of the fluid",
                         .check =
                             [] {
                               check_speed(1.0, 2.0, 0.6);
                               check_speed(0.5, 3.0, -1.5);
                               check_speed(2.0, 2.5, 0.9);
                             }},
                        {.title = "the flux of the invisible density",
                         .formula = "the integral of |x'|^2 = a^2 sin^2 t + b^2 cos^2 t over t",
                         .hint = "n.n = 1, and ds = |x'| dt",
                         .check =
                             [] {
                               check_invisible(2.0, 1.0);
                               check_invisible(1.0, 3.0);
                               check_invisible(1.5, 1.2);
                             }},
                        {.title = "the net flux of the data",
                         .formula = "Q = - the integral of n.eta ds",
                         .hint = "the integral of n times the equation",
                         .check =
                             [] {
                               check_flux(1.0, 0.7);
                               check_flux(2.5, -0.4);
                               check_flux(0.3, 1.2);
                             }},
                        {.title = "the torque of the wall",
                         .formula = "- the sum of L_k + (c_k - c) cross F_k",
                         .hint = "all torques about c add up to zero",
                         .check =
                             [] {
                               check_torque(0.4, {0.5, 0.4});
                               check_torque(1.3, {-1.0, 0.3});
                               check_torque(-0.7, {0.2, -0.8});
                             }},
                        {.title = "the rate of a load",
                         .formula = "the smaller one of 2 log(R_2/(R_1 + e)) and tau",
                         .hint = "the larger error has the smaller rate",
                         .check = [] {
                           check_rate(1.0, 2.0, 0.0);
                           check_rate(1.0, 2.0, 0.05);
                           check_rate(1.0, 2.0, 0.7);
                           check_rate(0.5, 2.0, 1.4);
                           check_rate(1.0, 1.5, 0.01);
                         }}});
}
