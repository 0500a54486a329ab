// Checks Fourier coefficients (01.9), Fourier differentiation and tails against known series.
#include "trapezoid/fourier.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;
using test::random_vector;

namespace {

template <class Function>
ComplexVector at_nodes(Index n, const Function& f) {
  ComplexVector values(n);
  for (Index j = 0; j < n; ++j) {
    values[j] = f(2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
  }
  return values;
}

Complex mode(int k, double t) {
  return std::polar(1.0, k * t);
}

}  // namespace

BOOST_AUTO_TEST_CASE(coefficients_of_a_trigonometric_polynomial) {
  const auto f = [](double t) {
    return Complex{2.0, -1.0} + 3.0 * mode(1, t) + imaginary * mode(-3, t) + 0.5 * mode(4, t);
  };
  for (Index n : {10, 11, 16, 210}) {
    ComplexVector expected = ComplexVector::Zero(n);
    expected[0] = {2.0, -1.0};
    expected[1] = 3.0;
    expected[n - 3] = imaginary;
    expected[4] = 0.5;
    BOOST_TEST(largest(fourier_coefficients(at_nodes(n, f)) - expected) < 2e-15);
  }
}

BOOST_AUTO_TEST_CASE(coefficients_of_a_geometric_series) {
  // 1 / (1 - q e^{it}) = sum_{k>=0} q^k e^{ikt}. Sampling adds the modes k + mN to the mode k
  // (01.9).
  const Complex q = std::polar(0.6, 0.4);
  constexpr Index n = 24;
  const ComplexVector c =
      fourier_coefficients(at_nodes(n, [&](double t) { return 1.0 / (1.0 - q * mode(1, t)); }));
  for (Index k = 0; k < n; ++k) {
    const Complex folded =
        std::pow(q, static_cast<int>(k)) / (1.0 - std::pow(q, static_cast<int>(n)));
    BOOST_TEST(std::abs(c[k] - folded) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(values_invert_coefficients) {
  for (Index n : {1, 2, 7, 30, 64, 997}) {
    const ComplexVector f = random_vector(n, 1);
    BOOST_TEST(largest(fourier_values(fourier_coefficients(f)) - f) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(wave_numbers_are_in_the_order_of_the_coefficients) {
  const auto check = [](Index n, std::initializer_list<Index> expected) {
    Index i = 0;
    for (Index k : expected) BOOST_TEST(wave_number(i++, n) == k);
    BOOST_TEST(i == n);
  };
  check(6, {0, 1, 2, -3, -2, -1});
  check(5, {0, 1, 2, -2, -1});
}

BOOST_AUTO_TEST_CASE(the_derivative_of_an_analytic_function) {
  // The modes of exp(sin t) decay faster than geometrically: 40 nodes resolve all of them.
  const ComplexVector f = at_nodes(40, [](double t) { return std::exp(imaginary + std::sin(t)); });
  const ComplexVector df =
      at_nodes(40, [](double t) { return std::cos(t) * std::exp(imaginary + std::sin(t)); });
  BOOST_TEST(largest(differentiate(f) - df) < 4e-14);
}

BOOST_AUTO_TEST_CASE(the_highest_mode_has_no_derivative) {
  const ComplexVector zigzag = at_nodes(12, [](double t) { return Complex{std::cos(6.0 * t)}; });
  BOOST_TEST(largest(zigzag) > 0.9);
  BOOST_TEST(largest(differentiate(zigzag)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_differentiation_matrix_differentiates) {
  for (Index n : {2, 4, 6, 50, 256}) {
    const ComplexVector f = random_vector(n, 2);
    const ComplexVector by_matrix = differentiation_matrix(n) * f;
    const double size = static_cast<double>(n);
    BOOST_TEST(largest(by_matrix - differentiate(f)) < 1e-15 * size * size);
  }
}

BOOST_AUTO_TEST_CASE(the_tail_is_what_the_highest_modes_carry) {
  // The tail consists of the modes |k| >= 64 - 8, of either sign.
  const auto tail = [](int k) {
    return fourier_tail(at_nodes(128, [k](double t) { return 1.0 + 0.25 * mode(k, t); }));
  };
  for (int k : {-64, -56, 56, 63}) BOOST_TEST(std::abs(tail(k) - 0.25) < 1e-15);
  for (int k : {-55, 0, 55}) BOOST_TEST(tail(k) < 1e-15);
}

BOOST_AUTO_TEST_CASE(odd_grids_are_refused_where_the_highest_mode_would_be_ambiguous) {
  const ComplexVector odd = random_vector(9, 3);
  BOOST_CHECK_THROW(differentiate(odd), std::invalid_argument);
  BOOST_CHECK_THROW(differentiation_matrix(9), std::invalid_argument);
  BOOST_CHECK_THROW(fourier_tail(odd), std::invalid_argument);
  BOOST_CHECK_THROW(resample(odd, 11), std::invalid_argument);
}
