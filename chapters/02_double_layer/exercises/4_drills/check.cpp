// Check of exercise 02.4: the reader's lines against the double layer and the Stokeslet of the book.
#include "chapters/check.hpp"

#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

enum class Place { in_the_fluid, on_the_curve, beyond_the_curve };

double layer_of_constant(Side side, Place place);
double pressure(Complex r, Complex force);
double moved_torque(Complex force, double torque, Complex from, Complex to);
Complex gauge_shift(Complex force, double viscosity, double before, double after);
double outflow(const ComplexVector& normals, const ComplexVector& density,
               const Eigen::VectorXd& weights);

namespace {

constexpr Eigen::Index nodes = 96;

// The layer of the density 1 on an ellipse, by the rule of the book, which is a multiple of 1/2.
double layer(Side side, Place place) {
  const Curve curve = sample(Ellipse{1.3, 1.0}, nodes, side);
  const StressletSum sum({curve});
  const ComplexVector ones = ComplexVector::Ones(nodes);
  if (place == Place::on_the_curve) {
    return 0.5 * std::round(2.0 * (sum(ones) + diagonal_velocity(curve, ones))[5].real());
  }
  const bool inside = (side == Side::fluid_inside) == (place == Place::in_the_fluid);
  const ComplexVector target{{Complex{inside ? 0.1 : 4.0, 0.2}}};
  return 0.5 * std::round(2.0 * sum(target, ones)[0].real());
}

void check_layer(Side side, Place place) {
  const double exact = layer(side, place), mean = layer(side, Place::on_the_curve);
  const std::string names[] = {"in the fluid", "on the curve", "beyond the curve"};
  expect({.what = (side == Side::fluid_outside ? "a body, target " : "a wall, target ") +
                  names[static_cast<int>(place)],
          .got = layer_of_constant(side, place),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{2.0 * mean - exact,
                        "the jump has the other sign: the limit from the fluid "
                        "is the value on the curve minus one half"},
                       {layer(Side::fluid_outside, place),
                        "these are the numbers of a body: at a wall the normal points outward"},
                       {mean, "this is the value on the curve, without the jump"}}});
}

void check_pressure(Complex r) {
  const Complex force{1.4, -0.6};
  const double exact = (force / r).real() / (2.0 * pi);
  expect({.what = "F = " + exercise::text(force) + ", r = " + exercise::text(r),
          .got = pressure(r, force),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {0.5 * exact, "this has the factor of the velocity, 1/(4 pi)"},
              {exact * std::abs(r), "this does not decay: divide by the square of the distance"},
              {-exact, "the sign is the other one: the pressure is high in front"},
              {(force * r).real() / (2.0 * pi * std::norm(r)),
               "r.F is the scalar product, not the product of complex numbers"}}});
}

void check_torque(double torque, Complex from, Complex to) {
  const Complex force{0.8, 1.1};
  const double total = torque + cross(from, force);
  const double exact = total - cross(to, force);
  expect(
      {.what = "L = " + exercise::text(torque) + ", F = " + exercise::text(force) + ", from " +
               exercise::text(from) + " to " + exercise::text(to),
       .got = moved_torque(force, torque, from, to),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{2.0 * torque - exact,
                     "the arm has the other direction: it leads from the new point to the old one"},
                    {torque, "the force has a torque about the new point"},
                    {total, "this is the total torque about the origin"}}});
}

void check_gauge(double before, double after) {
  const Complex force{0.9, -1.2}, r{0.7, 0.4};
  const double viscosity = 1.6;
  const Complex exact =
      stokeslet(r, force, viscosity, after) - stokeslet(r, force, viscosity, before);
  expect({.what = "gauge length " + exercise::text(before) + ", then " + exercise::text(after),
          .got = gauge_shift(force, viscosity, before, after),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{-exact, "the sign is the other one: -log(rho/l) grows with l"},
                       {2.0 * exact, "a square root is missing: the logarithm is that of a length"},
                       {viscosity * exact, "the viscosity is missing"},
                       {stokeslet(r, force, viscosity, after),
                        "this is a Stokeslet; the difference of two is asked for"}}});
}

// A star that is not symmetric about the origin.
void check_outflow(double stretch) {
  const Curve star = sample(Star{1.0, 0.2, 3}, nodes, Side::fluid_outside);
  const Curve curve = place(star, {0.4, -0.2}, 0.3);
  const ComplexVector normal = normals(curve);
  const Eigen::VectorXd weight = weights(curve);
  const ComplexVector density = (0.4 + stretch + 0.9 * imaginary) * curve.x.array() +
                                stretch * curve.x.conjugate().array().square();
  const Curve circle = sample(Circle{4.0}, nodes, Side::fluid_inside);
  const ComplexVector velocity = StressletSum({curve})(circle.x, density);
  const ComplexVector outward = normals(circle);
  const Eigen::VectorXd circle_weights = weights(circle);
  double exact = 0.0, product = 0.0, unweighted = 0.0;
  for (Eigen::Index j = 0; j < nodes; ++j) {
    exact += circle_weights[j] * dot(outward[j], velocity[j]);
    product += weight[j] * (normal[j] * density[j]).real();
    unweighted += dot(normal[j], density[j]);
  }
  expect(
      {.what = "eta = (0.4 + k + 0.9i) x + k conj(x)^2 on a star, k = " + exercise::text(stretch),
       .got = outflow(normal, density, weight),
       .expected = exact,
       .tolerance = 1e-10,
       .mistakes = {
           {-exact, "this is what flows into the circle"},
           {product, "this is the real part of the complex product; n.eta is Re(conj(n) eta)"},
           {unweighted, "the weights are missing"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the layer of a constant",
        .formula = "fluid, curve, beyond: 0, 1/2, 1 at a body and -1, -1/2, 0 at a wall",
        .hint = "the limit from the fluid is the value on the curve minus one half",
        .check =
            [] {
              for (const Side side : {Side::fluid_outside, Side::fluid_inside}) {
                for (const Place place :
                     {Place::in_the_fluid, Place::on_the_curve, Place::beyond_the_curve}) {
                  check_layer(side, place);
                }
              }
            }},
       {.title = "the pressure of a Stokeslet",
        .formula = "p = r.F / (2 pi rho^2)",
        .hint = "p is the derivative of log(rho)/(2 pi) in the direction of F",
        .check =
            [] {
              for (const Complex r : {Complex{0.5, 0.2}, Complex{-1.0, 2.0}, Complex{0.0, -3.0}}) {
                check_pressure(r);
              }
            }},
       {.title = "a force that moves",
        .formula = "L + (from - to) cross F",
        .hint = "the total torque about the origin stays the same",
        .check =
            [] {
              check_torque(0.7, {0.3, 0.1}, {-0.2, 0.6});
              check_torque(-0.4, {0.0, 0.0}, {1.0, -0.5});
              check_torque(0.0, {-0.7, 0.4}, {0.0, 0.0});
            }},
       {.title = "another gauge length",
        .formula = "log(after/before) F / (4 pi mu)",
        .hint = "subtract two Stokeslets",
        .check =
            [] {
              check_gauge(1.0, 3.0);
              check_gauge(2.0, 0.5);
              check_gauge(0.7, 10.0);
            }},
       {.title = "the outflow of a layer",
        .formula = "the integral of n.eta ds",
        .hint = "the outflow of one stresslet is n.eta",
        .check = [] {
          for (const double stretch : {0.5, 0.8, -1.7}) check_outflow(stretch);
        }}});
}
