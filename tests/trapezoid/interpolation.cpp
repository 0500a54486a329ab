// Checks the trigonometric interpolant between its nodes, and resampling to more or fewer nodes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"
#include "trapezoid/grading.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;
using test::random_vector;

namespace {

double node(Index j, Index n) {
  return 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
}

// f(t) = exp(a e^{it}) is the sum of a power series in e^{it} and has known derivatives.
struct Exponential {
  Complex a{0.5, 0.3};
  Complex value(double t) const { return std::exp(a * std::polar(1.0, t)); }
  Complex first(double t) const { return imaginary * a * std::polar(1.0, t) * value(t); }
  Complex second(double t) const {
    const Complex z = a * std::polar(1.0, t);
    return -(z + z * z) * value(t);
  }
  ComplexVector at_nodes(Index n) const {
    ComplexVector values(n);
    for (Index j = 0; j < n; ++j) values[j] = value(node(j, n));
    return values;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(jets_between_the_nodes) {
  const Exponential f;
  for (Index n : {32, 33}) {
    const TrigonometricPolynomial interpolant(f.at_nodes(n));
    for (double t : {-7.0, 0.0, 0.05, 1.0, 3.3, 6.28}) {
      const TrigonometricPolynomial::Jet jet = interpolant(t);
      BOOST_TEST(std::abs(jet.value - f.value(t)) < 5e-15);
      BOOST_TEST(std::abs(jet.first - f.first(t)) < 2e-14);
      BOOST_TEST(std::abs(jet.second - f.second(t)) < 2e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_interpolant_passes_through_the_nodes) {
  for (Index n : {1, 2, 3, 4, 9, 62, 63, 256}) {
    const ComplexVector values = random_vector(n, 4);
    const TrigonometricPolynomial interpolant(values);
    for (Index j = 0; j < n; ++j) {
      BOOST_TEST(std::abs(interpolant(node(j, n)).value - values[j]) < 1e-13);
    }
  }
  BOOST_CHECK_THROW(TrigonometricPolynomial{ComplexVector{}}, std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_interpolant_of_real_values_is_real) {
  // If the values are real, the highest mode must be a cosine, with one half for each sign of k.
  const ComplexVector values = random_vector(10, 5).real();
  const TrigonometricPolynomial interpolant(values);
  for (double t : {0.1, 1.0, 2.7}) {
    BOOST_TEST(std::abs(interpolant(t).value.imag()) < 1e-15);
    BOOST_TEST(std::abs(interpolant(t).first.imag()) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(resampling_up_keeps_the_interpolant) {
  for (Index n : {2, 3, 9, 10, 31}) {
    const ComplexVector values = random_vector(n, 6);
    for (Index m : {32, 90}) {
      const ComplexVector fine = resample(values, m);
      BOOST_TEST(largest(resample(fine, m) - fine) < 1e-14);
      for (Index j = 0; j < n; ++j) {
        const Complex back = TrigonometricPolynomial(fine)(node(j, n)).value;
        BOOST_TEST(std::abs(back - values[j]) < 5e-14);
      }
      const TrigonometricPolynomial interpolant(values);
      // Rounding errors grow with the number of modes.
      const double tolerance = 1e-14 * std::max(1.0, static_cast<double>(n) / 16.0);
      for (Index j = 0; j < m; ++j) {
        BOOST_TEST(std::abs(interpolant(node(j, m)).value - fine[j]) < tolerance);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(resampling_to_as_many_nodes_is_the_identity) {
  for (Index n : {2, 4, 10, 64}) {
    const ComplexVector values = random_vector(n, 7);
    BOOST_TEST(largest(resample(values, n) - values) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(curves_keep_their_parameter) {
  const Shape shape = Ellipse{2.0, 1.0};
  const Grading grading{{{0.7, 0.5}}, 1.0};
  const Curve fine = resample(sample(shape, 96, Side::fluid_inside, grading), 160);
  const Curve exact = sample(shape, 160, Side::fluid_inside, grading);
  BOOST_TEST(largest(fine.x - exact.x) < 1e-12);
  BOOST_TEST(largest(fine.dx - exact.dx) < 1e-12);
  BOOST_TEST(largest(fine.ddx - exact.ddx) < 1e-12);
  BOOST_TEST((fine.side == Side::fluid_inside));
}

BOOST_AUTO_TEST_CASE(weights_of_the_interpolant) {
  const ComplexVector values = random_vector(12, 5);
  const TrigonometricPolynomial interpolant(values);
  for (double t : {0.0, 0.3, node(1, 12), node(5, 12) + 1e-9, 6.2, -1.0, 20.0}) {
    const Complex value = interpolation_weights(12, t) * values;
    BOOST_TEST(std::abs(value - interpolant(t).value) < 1e-13);
  }
  BOOST_CHECK_THROW(interpolation_weights(7, 0.3), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(several_functions_at_once) {
  const std::vector<double> parameters{0.0, 0.7, -3.0, std::numbers::pi, 40.0};
  for (Eigen::Index n : {2, 12, 50}) {
    const Eigen::MatrixXcd values = Eigen::MatrixXcd::Random(n, 3);
    const Eigen::MatrixXcd found = interpolated(values, parameters);
    BOOST_REQUIRE(found.rows() == 5);
    for (Eigen::Index j = 0; j < 5; ++j) {
      const double t = parameters[static_cast<std::size_t>(j)];
      BOOST_TEST((found.row(j) - interpolation_weights(n, t) * values).norm() < 1e-12);
    }
  }
  BOOST_CHECK_THROW(interpolated(Eigen::MatrixXcd::Random(7, 2), parameters),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(resampling_down_cuts_the_series) {
  // 33 nodes resolve exp(a e^{it}) to rounding. The coarse grid keeps the modes 0 <= k < m/2.
  const Exponential f;
  for (Index n : {33, 34}) {
    for (Index m : {4, 8, 16, 32}) {
      const ComplexVector c = fourier_coefficients(resample(f.at_nodes(n), m));
      Complex term = 1.0;
      for (Index k = 0; k < m / 2; ++k) {
        BOOST_TEST(std::abs(c[k] - term) < 1e-15);
        term *= f.a / static_cast<double>(k + 1);
      }
      BOOST_TEST(largest(c.tail(m / 2)) < 1e-15);
    }
  }
}
