// Check of exercise 03.4: the reader's lines against rigid motions, circles and balances.
#include "chapters/check.hpp"

#include <numbers>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

Complex point_velocity(Complex velocity, double omega, Complex centre, Complex x);
double gyration_radius(const ComplexVector& x, const Eigen::VectorXd& weights);
double mean_rotation(const ComplexVector& x, const Eigen::VectorXd& weights,
                     const ComplexVector& density);
double turn_by_force(Complex velocity_under_torque, Complex force);
ComplexVector held_forces(const ComplexVector& velocities, double viscosity, Complex free_forces);

namespace {

void check_point(double omega, Complex x) {
  const Complex velocity{0.3, -0.8}, centre{1.0, 0.5};
  const auto about = [&](Complex c, double turn) {
    return Complex{velocity.real() - turn * (x.imag() - c.imag()),
                   velocity.imag() + turn * (x.real() - c.real())};
  };
  expect(
      {.what = "U = 0.3 - 0.8i, c = 1 + 0.5i, omega = " + exercise::text(omega) +
               ", x = " + exercise::text(x),
       .got = point_velocity(velocity, omega, centre, x),
       .expected = about(centre, omega),
       .tolerance = 1e-12,
       .mistakes = {
           {about(centre, -omega), "this turns the body clockwise"},
           {about(0.0, omega), "this turns the body about the origin; U is the velocity of c"},
           {velocity + omega * (x - centre), "this stretches the body: turn x - c by 90 degrees"},
           {velocity, "this is the translation alone"}}});
}

// An ellipse that is not at the origin; nodes are closer together at its tips.
Curve body(double a, double b) {
  return place(sample(Ellipse{a, b}, 48, Side::fluid_outside), {1.2, -0.7}, 0.4);
}

void check_radius(double a, double b) {
  const Curve curve = body(a, b);
  const Eigen::VectorXd weight = weights(curve);
  const double length = weight.sum(), square = weight.dot(curve.x.cwiseAbs2()) / length;
  // The centroid of an ellipse is its centre.
  const double exact = std::sqrt(square - std::norm(Complex{1.2, -0.7}));
  expect({.what = "ellipse " + exercise::text(a) + " : " + exercise::text(b) + " at 1.2 - 0.7i",
          .got = gyration_radius(curve.x, weight),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{std::sqrt(square), "this is the distance from the origin"},
                       {std::sqrt(0.5 * (a * a + b * b)),
                        "these are means over the nodes, which are not equally spaced"},
                       {exact * exact, "this is the mean square: a root is missing"},
                       {exact * std::sqrt(length), "the length of the curve is not divided by"}}});
}

// A rigid motion plus a stretching, which is orthogonal to all rigid motions.
void check_rotation(double omega, double stretch) {
  const Curve curve = body(1.5, 0.6);
  const Complex centre{1.2, -0.7}, translation{0.6, 0.9};
  const Eigen::VectorXd weight = weights(curve);
  const ComplexVector arm = curve.x.array() - centre;
  const ComplexVector density = translation + (stretch + imaginary * omega) * arm.array();
  double about_origin = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) {
    about_origin += weight[j] * cross(curve.x[j], density[j]);
  }
  const double square = weight.dot(arm.cwiseAbs2()) / weight.sum();
  expect({.what = "ellipse, omega = " + exercise::text(omega) + ", stretching " +
                  exercise::text(stretch),
          .got = mean_rotation(curve.x, weight, density),
          .expected = omega,
          .tolerance = 1e-12,
          .mistakes = {{omega * std::sqrt(square),
                        "this is a velocity: divide by the square of the gyration radius"},
                       {omega * square, "divide by the mean square of the arm"},
                       {about_origin / weight.dot(curve.x.cwiseAbs2()),
                        "a translation has a moment about the origin: take arms from the centroid"},
                       {-omega, "the sign is the other one"}}});
}

// A circle about the origin with the point c at another place: U = A F, omega = B (L + c cross F).
void check_turn(Complex point, Complex force) {
  const double rotation = 1.0 / (4.0 * pi);
  const Complex under_torque = rotation * perp(point);
  const double exact = rotation * cross(point, force);
  expect({.what = "V = " + exercise::text(under_torque) + ", F = " + exercise::text(force),
          .got = turn_by_force(under_torque, force),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{cross(under_torque, force), "this is the cross product"},
                       {-exact, "the sign is the other one: the mobility matrix is symmetric"},
                       {(under_torque * force).real(),
                        "this is the real part of the product of complex numbers"}}});
}

void check_held(Eigen::Index count, double viscosity, Complex free_forces) {
  ComplexVector velocities(count);
  const Complex ratio = std::polar(1.3, 0.7);
  for (Eigen::Index k = 0; k < count; ++k)
    velocities[k] = k == 0 ? ratio : ratio * velocities[k - 1];
  // Differences of forces are those of the velocities; with all others, the forces add up to zero.
  const ComplexVector bare = -4.0 * pi * viscosity * velocities;
  const auto with_total = [&](Complex total) -> ComplexVector {
    return bare.array() + (total - bare.sum()) / static_cast<double>(count);
  };
  const ComplexVector exact = with_total(-free_forces);
  expect(
      {.what = std::to_string(count) + " held bodies, free forces " + exercise::text(free_forces),
       .got = held_forces(velocities, viscosity, free_forces),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {
           {(exact.array() + bare.mean()).matrix(),
            "the mean velocity is not subtracted: the forces do not add up to zero"},
           {with_total(0.0),
            "the forces of the held bodies alone add up to zero here; the free ones count too"},
           {with_total(free_forces), "the free forces have the other sign"},
           {with_total(-static_cast<double>(count) * free_forces),
            "every held body balances all of the free forces: they share it"},
           {-exact, "the signs are the other ones"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the velocity of a point",
        .formula = "U + omega (x - c) turned by +90 degrees",
        .hint = "multiply by i, or use perp()",
        .check =
            [] {
              for (const double omega : {0.5, -2.0}) {
                check_point(omega, {1.5, 0.2});
                check_point(omega, {0.1, -0.4});
              }
            }},
       {.title = "the gyration radius",
        .formula = "the root of the mean of |x - <x>|^2",
        .hint = "a mean is a weighted sum, divided by the sum of the weights",
        .check =
            [] {
              check_radius(0.8, 0.5);
              check_radius(1.5, 0.4);
              check_radius(2.0, 1.9);
            }},
       {.title = "the rotation of a density",
        .formula = "<(x - <x>) cross eta> / <|x - <x>|^2>",
        .hint = "eta.(x - <x>)^perp = (x - <x>) cross eta",
        .check =
            [] {
              check_rotation(0.7, 0.0);
              check_rotation(-1.3, 0.5);
              check_rotation(2.0, -0.9);
            }},
       {.title = "the turn under a force",
        .formula = "omega' L = U.F', with L = 1",
        .hint = "the reciprocal theorem for two loads of one body",
        .check =
            [] {
              check_turn({0.3, 0.1}, {1.0, -0.4});
              check_turn({-0.2, 0.5}, {0.7, 0.9});
              check_turn({0.0, 0.6}, {-1.1, 0.3});
            }},
       {.title = "forces on held bodies",
        .formula = "-4 pi mu (U_w - mean of U) - free forces / number of held bodies",
        .hint = "all forces add up to zero",
        .check = [] {
          check_held(2, 1.0, {0.5, -0.2});
          check_held(3, 0.4, {-1.0, 0.8});
          check_held(4, 2.5, {0.3, 1.1});
        }}});
}
