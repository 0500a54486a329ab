// Check of exercise 07.4: the reader's lines against linear flows, cylinders, and a known layer.
#include "chapters/check.hpp"

#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

double shear_gradient(Complex strain, double vorticity);
double dissipation(Complex strain, double vorticity, double viscosity);
double friction(double vorticity, double omega, double viscosity);
double pressure_in_the_fluid(double mean, Complex tangent, Complex density_slope, double viscosity);
Complex pair_stresslet(Complex force, Complex y);

namespace {

// A linear flow without divergence, by the derivatives of its velocity.
struct Gradient {
  double d1u1, d2u1, d1u2;

  Complex strain() const { return {2.0 * d1u1, d1u2 + d2u1}; }
  double vorticity() const { return d1u2 - d2u1; }
  std::string text() const {
    return "q = " + exercise::text(strain()) + ", w = " + exercise::text(vorticity());
  }
};

constexpr Gradient flows[] = {{0.0, 1.0, 0.0}, {0.7, -0.4, 1.1}, {-0.2, 0.9, 0.5}};

void check_gradient(const Gradient& flow) {
  expect({.what = flow.text(),
          .got = shear_gradient(flow.strain(), flow.vorticity()),
          .expected = flow.d2u1,
          .tolerance = 1e-12,
          .mistakes = {{flow.d1u2, "this is the derivative of u_2 in direction 1"},
                       {2.0 * flow.d2u1, "this is twice the derivative"},
                       {-flow.d2u1, "the sign is the other one"},
                       {0.5 * (flow.strain().real() - flow.vorticity()),
                        "the imaginary part of q is 2 e_12"}}});
}

void check_dissipation(const Gradient& flow, double viscosity) {
  const double shear = 0.5 * (flow.d2u1 + flow.d1u2);
  const double square = 2.0 * flow.d1u1 * flow.d1u1 + 2.0 * shear * shear;  // e:e
  const double all = 2.0 * flow.d1u1 * flow.d1u1 + flow.d2u1 * flow.d2u1 + flow.d1u2 * flow.d1u2;
  const double exact = 2.0 * viscosity * square;
  expect({.what = flow.text() + ", mu = " + exercise::text(viscosity),
          .got = dissipation(flow.strain(), flow.vorticity(), viscosity),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {viscosity * all, "this takes the whole velocity gradient: a rotation makes no heat"},
              {0.5 * exact, "e:e has four entries, which are two pairs of equal ones"},
              {2.0 * exact, "q is twice the strain rate: |q|^2 is twice e:e"},
              {viscosity * std::sqrt(exact / viscosity),
               "this is the largest shear stress: a square is missing"}}});
}

// Between circles the velocity is C rho + B/rho; the shear stress at rho is -2 mu B/rho^2.
void check_friction(double c, double b, double viscosity) {
  const double radius = 0.8, vorticity = 2.0 * c, omega = c + b / (radius * radius);
  // On the inner circle, n points to the centre and tau is clockwise: two signs, which cancel.
  const double exact = -2.0 * viscosity * b / (radius * radius);
  expect({.what = "w = " + exercise::text(vorticity) + ", omega = " + exercise::text(omega) +
                  ", mu = " + exercise::text(viscosity),
          .got = friction(vorticity, omega, viscosity),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{viscosity * (vorticity - omega),
                        "the vorticity of a rotation is twice omega: fluid that turns with the "
                        "body exerts no friction"},
                       {-exact, "this is the force of the fluid on the surface"},
                       {viscosity * vorticity, "this is right on a surface that does not turn"},
                       {exact / viscosity, "the viscosity is missing"}}});
}

// The density c exp(-ikt) + d exp(ikt) on the unit circle of a body. Outside phi = -c z^{-k}/2, and
// inside phi = d z^k/2.
void check_pressure(int k, double t) {
  const Complex c{0.8, -1.1}, d{0.3, 0.5};
  const double viscosity = 1.4, order = k;
  const Complex slope_outside = 0.5 * order * c * std::polar(1.0, -(order + 1.0) * t);
  const Complex slope_inside = 0.5 * order * d * std::polar(1.0, (order - 1.0) * t);
  const double exact = -4.0 * viscosity * slope_outside.real();
  const double mean = 0.5 * exact - 2.0 * viscosity * slope_inside.real();
  const Complex tangent = -imaginary * std::polar(1.0, t);  // clockwise
  const Complex density_slope =
      imaginary * order * (c * std::polar(1.0, -order * t) - d * std::polar(1.0, order * t));
  expect(
      {.what = "density c exp(-ikt) + d exp(ikt), k = " + std::to_string(k) +
               ", t = " + exercise::text(t),
       .got = pressure_in_the_fluid(mean, tangent, density_slope, viscosity),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{2.0 * mean - exact, "this is the pressure on the other side"},
                    {2.0 * exact - mean, "this adds the whole jump: the mean lacks half of it"},
                    {mean, "this is the mean of both sides"},
                    {mean + (exact - mean) / viscosity, "the viscosity is missing in the jump"}}});
}

void check_pair(Complex force, Complex y) {
  // The traceless symmetric part of the dyad of force and position, on the body.
  const double s11 = -0.5 * (force.real() * y.real() - force.imag() * y.imag());
  const double s12 = -0.5 * (force.real() * y.imag() + force.imag() * y.real());
  const Complex exact{s11, s12};
  expect({.what = "F = " + exercise::text(force) + ", y = " + exercise::text(y),
          .got = pair_stresslet(force, y),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{-exact, "this is the dipole of the forces on the fluid"},
                       {-0.5 * force * std::conj(y),
                        "this is the scalar product and the torque: take the complex product"},
                       {2.0 * exact, "this is twice the stresslet: the arm of each force is y/2"},
                       {0.5 * exact, "both forces contribute: this is half of the stresslet"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "a derivative of the velocity",
                         .formula = "(Im q - w)/2",
                         .hint = "2 e_12 is the sum of two derivatives, and w their difference",
                         .check =
                             [] {
                               for (const Gradient& flow : flows) check_gradient(flow);
                             }},
                        {.title = "the dissipation",
                         .formula = "2 mu e:e = mu |q|^2",
                         .hint = "a rotation makes no heat",
                         .check =
                             [] {
                               for (const Gradient& flow : flows) check_dissipation(flow, 1.3);
                               check_dissipation({0.0, -1.0, 1.0}, 0.7);
                             }},
                        {.title = "the friction",
                         .formula = "mu (w - 2 omega)",
                         .hint = "a rotation with omega has the vorticity 2 omega",
                         .check =
                             [] {
                               check_friction(0.5, 0.3, 1.0);
                               check_friction(-0.2, 1.1, 2.4);
                               check_friction(1.5, -0.6, 0.7);
                             }},
                        {.title = "the pressure in the fluid",
                         .formula = "mean - [p]/2 = mean + mu tau.(d eta/ds)",
                         .hint = "the jump is the other side minus the fluid",
                         .check =
                             [] {
                               for (const int k : {1, 2, 4}) {
                                 check_pressure(k, 0.4);
                                 check_pressure(k, 2.9);
                               }
                             }},
                        {.title = "the stresslet of a pair",
                         .formula = "S_11 + i S_12 = -F y/2, a complex product",
                         .hint = "the fluid exerts the opposite forces on the body",
                         .check = [] {
                           check_pair({1.0, 0.0}, {2.0, 0.0});
                           check_pair({0.6, -0.9}, {0.4, 1.2});
                           check_pair({-1.1, 0.5}, {0.7, -0.8});
                         }}});
}
