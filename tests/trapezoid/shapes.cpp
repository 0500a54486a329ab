// Checks that every shape's points lie on the shape's curve and run once around it
// counter-clockwise, and that the derivatives agree with finite differences and with Fourier
// differentiation.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;

namespace {

const std::vector<Shape> analytic_shapes = {
    Circle{0.7},         Ellipse{2.0, 1.0},         Ellipse{0.3, 1.5},        Star{1.3, 0.2, 5},
    Star{0.8, -0.35, 3}, Superellipse{2.0, 1.0, 4}, Superellipse{1.0, 1.0, 6}};

// Returns the central difference of order 8; `stencil` holds the weights of f(+k) -+ f(-k).
ComplexVector difference(const ComplexVector& f, const std::vector<double>& stencil, double middle,
                         double parity) {
  const Index n = f.size();
  ComplexVector result = middle * f;
  for (Index j = 0; j < n; ++j) {
    for (Index k = 1; k <= 4; ++k) {
      result[j] +=
          stencil[static_cast<std::size_t>(k - 1)] * (f[(j + k) % n] + parity * f[(j + n - k) % n]);
    }
  }
  return result;
}

ComplexVector first_difference(const ComplexVector& f, double h) {
  return difference(f, {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0}, 0.0, -1.0) / h;
}

ComplexVector second_difference(const ComplexVector& f, double h) {
  return difference(f, {8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0}, -205.0 / 72.0, 1.0) /
         (h * h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(scaled_shapes_have_scaled_points) {
  std::vector<Shape> originals = analytic_shapes;
  originals.emplace_back(NodalCurve{sample(Ellipse{2.0, 1.0}, 16, Side::fluid_outside).x, {}});
  for (const Shape& original : originals) {
    const ComplexVector x = sample(original, 32, Side::fluid_outside).x;
    BOOST_TEST(largest(sample(scaled(original, 1.7), 32, Side::fluid_outside).x - 1.7 * x) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_finite_differences) {
  // The truncation error h^8 f^(9) / 630 is below the rounding errors eps / h and eps / h^2.
  constexpr Index n = 2048;
  const double h = 2.0 * std::numbers::pi / static_cast<double>(n);
  for (const Shape& shape : analytic_shapes) {
    const Curve curve = sample(shape, n, Side::fluid_outside);
    BOOST_TEST(largest(first_difference(curve.x, h) - curve.dx) < 1e-12);
    BOOST_TEST(largest(second_difference(curve.x, h) - curve.ddx) < 2e-9);
  }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_fourier_series) {
  // Differentiation multiplies rounding errors by N/2.
  constexpr Index n = 512;
  for (const Shape& shape : analytic_shapes) {
    const Curve curve = sample(shape, n, Side::fluid_outside);
    const double size = largest(curve.x);
    BOOST_TEST(largest(differentiate(curve.x) - curve.dx) < 5e-13 * size);
    BOOST_TEST(largest(differentiate(curve.dx) - curve.ddx) < 5e-12 * size);
  }
}

BOOST_AUTO_TEST_CASE(nodes_lie_on_the_curve) {
  const auto of = [](const Shape& shape) { return sample(shape, 30, Side::fluid_outside).x; };
  for (Complex x : of(Circle{0.7})) BOOST_TEST(std::abs(std::abs(x) - 0.7) < 1e-15);
  for (Complex x : of(Ellipse{2.0, 0.5})) {
    BOOST_TEST(std::abs(std::hypot(x.real() / 2.0, x.imag() / 0.5) - 1.0) < 1e-15);
  }
  for (Complex x : of(Star{1.3, 0.2, 5})) {
    BOOST_TEST(std::abs(std::abs(x) - 1.3 * (1.0 + 0.2 * std::cos(5.0 * std::arg(x)))) < 3e-15);
  }
  for (int power : {2, 4, 8}) {
    for (Complex x : of(Superellipse{2.0, 0.5, power})) {
      const double level = std::pow(x.real() / 2.0, power) + std::pow(x.imag() / 0.5, power);
      BOOST_TEST(std::abs(level - 1.0) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(nodes_start_on_direction_1_and_are_equidistant_in_the_parameter) {
  for (const Shape& shape : analytic_shapes) {
    const Curve coarse = sample(shape, 16, Side::fluid_outside);
    const Curve fine = sample(shape, 32, Side::fluid_outside);
    BOOST_TEST(coarse.x[0].imag() == 0.0);
    BOOST_TEST(coarse.x[0].real() > 0.0);
    BOOST_TEST(coarse.x[1].imag() > 0.0);
    for (Index j = 0; j < 16; ++j) BOOST_TEST(coarse.x[j] == fine.x[2 * j]);
  }
}

BOOST_AUTO_TEST_CASE(a_superellipse_of_power_2_is_an_ellipse) {
  const Curve superellipse = sample(Superellipse{2.0, 0.5, 2}, 64, Side::fluid_outside);
  const Curve ellipse = sample(Ellipse{2.0, 0.5}, 64, Side::fluid_outside);
  BOOST_TEST(largest(superellipse.x - ellipse.x) < 1e-15);
  BOOST_TEST(largest(superellipse.dx - ellipse.dx) < 2e-15);
  BOOST_TEST(largest(superellipse.ddx - ellipse.ddx) < 4e-15);
}

BOOST_AUTO_TEST_CASE(odd_and_tiny_numbers_of_nodes_are_refused) {
  for (const Shape& shape : {Shape{Circle{1.0}}, Shape{NodalCurve{ComplexVector::Ones(8), ""}}}) {
    for (Index n : {-2, 0, 2, 3, 5, 65}) {
      BOOST_CHECK_EXCEPTION(sample(shape, n, Side::fluid_outside), std::invalid_argument,
                            [n](const std::invalid_argument& error) {
                              return std::string(error.what()).find(std::to_string(n)) !=
                                     std::string::npos;
                            });
    }
  }
}
