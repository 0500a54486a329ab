// Check of exercise 04.1: closed forms against the matrices of the book.
#include "chapters/check.hpp"

#include <array>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "support/dense.hpp"
#include "support/spectra.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

std::array<double, 4> eigenvalues(double radius, double factor);
double condition(double radius, double factor);
double largest_factor(double radius, double bound);
ComplexVector density(const Curve& wall, const ComplexVector& velocity);
ComplexVector stretched(const Ellipse& ellipse, const Curve& wall);

namespace {

std::string arguments(double radius, const std::string& name, double value) {
  return "R = " + exercise::text(radius) + ", " + name + " = " + exercise::text(value);
}

Curve circular_wall(double radius) {
  return place(sample(Circle{radius}, 16, Side::fluid_inside), {0.3, -2.0}, 0.4);
}

// -1/2 + D + f n \int n . eta ds.
Eigen::MatrixXd matrix_of(const Curve& wall, double factor) {
  Eigen::MatrixXd matrix =
      double_layer_matrix(wall) - factor * perimeter(wall) * null_space_matrix(wall);
  matrix.diagonal().array() -= 0.5;
  return matrix;
}

void check_eigenvalues(double radius, double factor) {
  const Curve wall = circular_wall(radius);
  const Eigen::MatrixXd matrix = matrix_of(wall, factor);
  const ComplexVector n = normals(wall);
  const auto eigenvalue = [&](const ComplexVector& v) {
    const Eigen::VectorXd image = matrix * interleaved(v);
    return image.dot(interleaved(v)) / v.squaredNorm();
  };
  const ComplexVector rotation = imaginary * n, other = n.cwiseProduct(n);
  const Eigen::Vector4d exact{eigenvalue(ComplexVector::Ones(n.size())), eigenvalue(rotation),
                              eigenvalue(n), eigenvalue(other)};
  const std::array<double, 4> got = eigenvalues(radius, factor);
  Eigen::Vector4d body{0.0, 0.0, exact[2] - 1.0, exact[3]}, no_length = exact, without = exact;
  no_length[2] = factor;
  without[2] = 0.0;
  expect(
      {.what = arguments(radius, "f", factor),
       .got = Eigen::Map<const Eigen::Vector4d>(got.data()),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {
           {body, "this is the circle of a body: a wall has the fluid inside, and D of both signs"},
           {no_length, "the integral of n.n is missing: it is the length of the wall"},
           {without, "this is -1/2 + D: the factor moves the eigenvalue of the normal"}}});
}

double exact_condition(double radius, double factor) {
  return test::condition_number(matrix_of(circular_wall(radius), factor));
}

void check_condition(double radius, double factor) {
  const double moved = 2.0 * pi * radius * factor;
  expect({.what = arguments(radius, "f", factor),
          .got = condition(radius, factor),
          .expected = exact_condition(radius, factor),
          .tolerance = 1e-11,
          .mistakes = {{2.0 * std::abs(moved), "this holds for large factors only"},
                       {std::max(1.0, moved) / std::min(0.5, moved),
                        "singular values have no sign: take the modulus of the eigenvalue"},
                       {std::max(1.0, std::abs(moved)), "the least singular value is missing"}}});
}

void check_largest(double radius, double bound) {
  const double exact = 0.5 * bound / perimeter(circular_wall(radius));
  expect(
      {.what = arguments(radius, "bound", bound),
       .got = largest_factor(radius, bound),
       .expected = exact,
       .tolerance = 1e-11,
       .mistakes = {{2.0 * exact, "the least singular value is 1/2, not 1"},
                    {-exact, "of two factors with this condition number, it is the negative one"},
                    {1.0 / (2.0 * pi * radius * bound),
                     "this is the least one: factors near 0 have a bound as well"},
                    {0.5 / (2.0 * pi * radius * bound),
                     "this is near the least one, not the largest: the moved eigenvalue is to be "
                     "the largest in modulus"},
                    {exact / radius, "the eigenvalue has the length of the wall in it"}}});
}

void check_density(double radius) {
  const Curve wall = circular_wall(radius);
  const ComplexVector n = normals(wall), squares = n.cwiseProduct(n);
  // Translation, rotation, a net flux, and modes 2, -1 and -2.
  const ComplexVector g =
      (Complex{0.3, -0.7} + Complex{0.5, 0.9} * n.array() + Complex{-0.4, 0.2} * squares.array() +
       Complex{0.1, 0.6} * n.conjugate().array() - 0.8 * squares.conjugate().array())
          .matrix();
  const Eigen::VectorXd solution =
      test::solve(matrix_of(wall, -1.0 / perimeter(wall)), interleaved(g));
  const ComplexVector exact = deinterleaved(solution);
  const Complex mean = g.mean(), first = n.dot(g) / static_cast<double>(g.size());
  const ComplexVector others = -2.0 * g;
  const ComplexVector normal_only = (others + first.real() * n).array() + mean;
  const ComplexVector no_mean = others + first * n, no_first = others.array() + mean;
  expect({.what = "R = " + exercise::text(radius) + ", all modes from -2 to 2",
          .got = density(wall, g),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{others,
                        "this inverts the jump alone: translations, rotation and normal "
                        "have the eigenvalue -1, not -1/2"},
                       {normal_only, "the rotation has the eigenvalue -1 too, as the normal has"},
                       {no_mean, "translations have the eigenvalue -1, not -1/2"},
                       {no_first, "rotation and normal have the eigenvalue -1, not -1/2"},
                       {-exact, "the sign is the other one: the eigenvalues are negative"}}});
}

void check_stretched(const Ellipse& ellipse) {
  const Curve wall = sample(ellipse, 64, Side::fluid_inside);
  const ComplexVector g = wall.x.conjugate();
  const Eigen::VectorXd solution =
      test::solve(matrix_of(wall, -1.0 / perimeter(wall)), interleaved(g));
  const ComplexVector exact = deinterleaved(solution);
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  // e^{-it}, in units of the mean semi-axis.
  const ComplexVector turning = (g - m * wall.x) / (1.0 - m * m);
  expect(
      {.what = "a = " + exercise::text(ellipse.a) + ", b = " + exercise::text(ellipse.b),
       .got = stretched(ellipse, wall),
       .expected = exact,
       .tolerance = 1e-11,
       .mistakes = {{ComplexVector(-2.0 * g), "this is right on a circle"},
                    {ComplexVector(-2.0 * turning),
                     "this makes the right flow, but has a flux: N_0 takes the one without"},
                    {ComplexVector(-2.0 / (1.0 - m * m) * g), "the sign of m^2 is the other one"},
                    {ComplexVector(-exact), "the sign is the other one"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the eigenvalues",
        .formula = "-1/2 + D + f n int n.eta ds, with D eta = -1/2 eta_0 + 1/2 conj(eta_1) e^{it}",
        .hint = "insert 1, i e^{it}, e^{it} and e^{2it}",
        .check =
            [] {
              check_eigenvalues(1.0, 1.0);
              check_eigenvalues(0.2, -3.0);
            }},
       {.title = "the condition number",
        .formula = "max(1, |2 pi R f|) / min(1/2, |2 pi R f|)",
        .hint = "the moduli of the eigenvalues of task 1",
        .check =
            [] {
              for (double factor : {5.0, -5.0, -0.1, 0.02, -0.001}) check_condition(1.3, factor);
            }},
       {.title = "the largest factor",
        .formula = "|2 pi R f| / (1/2) = bound",
        .hint = "for bounds above 2 the moved eigenvalue is the largest",
        .check =
            [] {
              check_largest(1.0, 20.0);
              check_largest(0.03, 5.0);
            }},
       {.title = "the density",
        .formula = "eta = -2 g + g_0 + g_1 e^{it}",
        .hint = "g_0 is the mean of g, g_1 that of g conj(n)",
        .check =
            [] {
              for (double radius : {0.5, 7.0}) check_density(radius);
            }},
       {.title = "the density on an ellipse",
        .formula = "(-1/2 + D) eta = (x, -y), and no flux: eta_1 = m eta_{-1}",
        .hint = "(x, -y) is e^{-it} + m e^{it}; try a multiple of it",
        .check = [] {
          check_stretched({2.0, 1.0});
          check_stretched({0.3, 0.9});
        }}});
}
