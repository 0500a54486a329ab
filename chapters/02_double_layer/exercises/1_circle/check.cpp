// Check of exercise 02.1: the reader's closed forms against the book's kernel and matrix.
#include "chapters/check.hpp"

#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

double diagonal(Complex dx, Complex ddx, Side side);
Complex circle_kernel(double alpha, double beta, Complex eta, Side side);
Complex layer_on_circle(double alpha, Complex eta_0, Complex eta_1, Side side);
Complex density_mode(int k, Complex u_k);

namespace {

std::string place(Side side) {
  return side == Side::fluid_inside ? "fluid inside" : "fluid outside";
}

// Modes k = -2 ... 3 of a density without symmetry.
constexpr int lowest = -2, modes = 6;
const ComplexVector coefficients{
    {{0.3, -0.2}, {-0.7, 0.4}, {1.1, 0.6}, {0.5, -0.9}, {-0.2, 0.8}, {0.1, 0.3}}};

Complex mode(int k) {
  return coefficients[k - lowest];
}

ComplexVector node_values(const ComplexVector& of_modes, Index n) {
  ComplexVector c = ComplexVector::Zero(n);
  for (int k = lowest; k < lowest + modes; ++k) c[(k + n) % n] = of_modes[k - lowest];
  return fourier_values(c);
}

// The kernel beside a node, where it is a number times its limit: extrapolated to the node from
// the mean of both sides.
void check_diagonal(Side side) {
  constexpr double a = 2.0, b = 0.7, angle = 0.8;
  const Complex dx{-a * std::sin(angle), b * std::cos(angle)};
  const Complex ddx{-a * std::cos(angle), -b * std::sin(angle)};
  const double kappa = a * b / std::pow(std::abs(dx), 3);
  const double exact = -static_cast<double>(side) * kappa / (2.0 * pi);
  expect({.what = "ellipse (2 cos t, 0.7 sin t) at t = 0.8, " + place(side),
          .got = diagonal(dx, ddx, side),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {-exact, "the sign is the other one: k = x_ss.n is -s times the curvature"},
              {2.0 * exact,
               "twice the limit: the normal at the source turns too, and takes half "
               "of r.n away"},
              {pi * exact, "the factor 1/pi of the kernel is missing"},
              {exact * std::pow(std::abs(dx), 3), "the curvature is per length: |x'|^3 is missing"},
              {std::abs(exact), "this does not depend on the side of the fluid"},
              {-std::abs(exact), "this does not depend on the side of the fluid"}}});
}

void check_kernel(double alpha, double beta, Side side) {
  const Complex eta{0.4, -1.3};
  const double s = static_cast<double>(side);
  const Complex tangent = imaginary * std::polar(1.0, alpha);
  const Complex exact = alpha == beta ? -s / (2.0 * pi) * dot(tangent, eta) * tangent
                                      : stresslet(std::polar(1.0, alpha) - std::polar(1.0, beta),
                                                  s * std::polar(1.0, beta), eta);
  const Complex even = -s / (2.0 * pi) * eta;  // the sum of both signs of the second term
  expect({.what = "alpha = " + exercise::text(alpha) + ", beta = " + exercise::text(beta) + ", " +
                  place(side),
          .got = circle_kernel(alpha, beta, eta, side),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{even - exact,
                        "the chord is at right angles to the mean direction: r/conj(r) = "
                        "-exp(i (alpha + beta))"},
                       {-exact, "the sign is the other one: r.n = -s rho^2/2"},
                       {2.0 * exact, "twice the kernel: (r.eta) r has a factor 1/2 as well"},
                       {pi * exact, "the factor 1/pi is missing"}}});
}

void check_layer(double alpha, Side side) {
  constexpr Index n = 32;
  const Curve circle = sample(Circle{1.0}, n, side);
  const ComplexVector density = node_values(coefficients, n);
  const Eigen::VectorXd velocity = double_layer_matrix(circle) * interleaved(density);
  const ComplexVector at_nodes = deinterleaved(velocity);
  const Complex exact = TrigonometricPolynomial(at_nodes)(alpha).value;
  const Complex turn = std::polar(1.0, alpha);
  const double s = static_cast<double>(side);
  expect({.what = "alpha = " + exercise::text(alpha) + ", " + place(side),
          .got = layer_on_circle(alpha, mode(0), mode(1), side),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {-0.5 * s * (mode(0) - turn * mode(1)),
               "eta_1 without its conjugate: the kernel contains conj(eta)"},
              {-0.5 * s * (mode(0) + turn * std::conj(mode(1))), "the sign of the mode 1"},
              {exact - 0.5 * mode(0) - 0.5 * turn * mode(1), "this has a part of the jump in it"},
              {2.0 * exact, "twice the value"},
              {-exact, "the sign is the other one"}}});
}

void check_density(double factor) {
  constexpr Index n = 32;
  const Curve circle = sample(Circle{1.0}, n, Side::fluid_inside);
  ComplexVector u = factor * coefficients, got(modes), jump_only(modes);
  u[1 - lowest] = imaginary * u[1 - lowest].imag();  // no net flux
  for (int k = lowest; k < lowest + modes; ++k) got[k - lowest] = density_mode(k, u[k - lowest]);
  jump_only = -2.0 * u;
  const auto limit_of = [&](const ComplexVector& of_modes) -> ComplexVector {
    const ComplexVector density = node_values(of_modes, n);
    const Eigen::VectorXd layer = double_layer_matrix(circle) * interleaved(density);
    return deinterleaved(layer) - 0.5 * density;
  };
  expect({.what = "the limit of your density, at 32 nodes, for " + exercise::text(factor) + " u",
          .got = limit_of(got),
          .expected = node_values(u, n),
          .tolerance = 1e-12,
          .mistakes = {
              {limit_of(jump_only), "this inverts the jump alone: D acts on the modes 0 and 1"}}});
  expect({.what = "the normal part of the density, Re eta_1",
          .got = got[1 - lowest].real(),
          .expected = 0.0,
          .tolerance = 1e-12});
}

}  // namespace

int main() {
  const auto both = {Side::fluid_inside, Side::fluid_outside};
  return exercise::run({{.title = "the diagonal",
                         .formula = "k/(2 pi) t (t.eta), k = x_ss.n",
                         .hint = "r.n = (k/2) sigma^2: expand the source and its normal",
                         .check =
                             [&] {
                               for (Side side : both) check_diagonal(side);
                             }},
                        {.title = "the kernel",
                         .formula = "(1/pi) (r.n/rho^2) (eta + (r/conj(r)) conj(eta))/2",
                         .hint = "r.n/rho^2 = -s/2 for any two points of the unit circle",
                         .check =
                             [&] {
                               for (Side side : both) {
                                 check_kernel(0.3, 2.1, side);
                                 check_kernel(-1.2, -1.2, side);
                               }
                             }},
                        {.title = "the principal value",
                         .formula = "the integral of the kernel over beta",
                         .hint = "the integral of exp(i beta) conj(eta) is 2 pi conj(eta_1)",
                         .check =
                             [&] {
                               for (Side side : both) check_layer(0.7, side);
                             }},
                        {.title = "the density",
                         .formula = "-eta_k/2 + (D eta)_k = u_k",
                         .hint = "for k = 1 split eta_1 into its real and imaginary part",
                         .check = [] {
                           for (double factor : {1.0, -0.5}) check_density(factor);
                         }}});
}
