// Checks that the periodic trapezoid rule (01.2) converges geometrically, at the rate of the
// nearest pole (01.6) and no faster, and that a jump reduces the rule to second order (table 1 of
// the published convergence study).
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using std::numbers::pi;

namespace {

// Integrates over [0, 2 pi] by the trapezoid rule, with the weights of the unit circle's nodes.
template <class Function>
double integrate(Index n, const Function& f) {
  const Curve circle = sample(Circle{1.0}, n, Side::fluid_outside);
  const Eigen::VectorXd w = weights(circle);
  double sum = 0.0;
  for (Index j = 0; j < n; ++j) {
    sum += w[j] * f(2.0 * pi * static_cast<double>(j) / static_cast<double>(n));
  }
  return sum;
}

// Returns whether the first three digits agree. The table prints only three digits.
bool matches(double value, double printed) {
  return std::abs(value - printed) < 5e-3 * printed;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_pole_sets_the_rate) {
  // Poisson's kernel has poles at Im t = +-log(1/q). By (01.5) the modes q^|k| with k = mN are
  // added to the mode k = 0, so that the relative error is exactly 2 q^N / (1 - q^N).
  for (double q : {0.3, 0.6, 0.9}) {
    for (Index n = 4; std::pow(q, static_cast<double>(n)) > 1e-10; n += 4) {
      const double sum = integrate(
          n, [q](double t) { return (1.0 - q * q) / (1.0 - 2.0 * q * std::cos(t) + q * q); });
      const double folded = std::pow(q, static_cast<double>(n));
      const double predicted = 2.0 * folded / (1.0 - folded);
      BOOST_TEST(std::abs((sum / (2.0 * pi) - 1.0) / predicted - 1.0) < 1e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_perimeter_of_an_ellipse_converges_with_its_branch_points) {
  // The speed |x'| has branch points sqrt(t - t_0) at e^{-2 |Im t_0|} = m = (a - b) / (a + b), so
  // that the error is about m^{N/2} N^{-3/2} (01.8). The test bounds the slope between N and N + 8
  // from both sides.
  const double a = 3.0, b = 1.0, m = (a - b) / (a + b);
  const double exact = 4.0 * a * std::comp_ellint_2(std::sqrt(1.0 - b * b / (a * a)));
  const auto error = [&](Index n) {
    return std::abs(perimeter(sample(Ellipse{a, b}, n, Side::fluid_outside)) - exact);
  };
  for (Index n = 16; n <= 56; n += 8) {
    const double algebraic = 1.5 * std::log(static_cast<double>(n) / static_cast<double>(n + 8));
    const double slope = (std::log(error(n + 8) / error(n)) - algebraic) / 8.0;
    BOOST_TEST(std::abs(slope / (0.5 * std::log(m)) - 1.0) < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(published_table_of_a_periodic_function) {
  const double exact = integrate(64, [](double t) { return std::exp(std::cos(t)); });
  BOOST_TEST(std::abs(exact - 2.0 * pi * std::cyl_bessel_i(0.0, 1.0)) < 1e-14);
  const auto error = [&](Index n) {
    return std::abs(integrate(n, [](double t) { return std::exp(std::cos(t)); }) / exact - 1.0);
  };
  BOOST_TEST(matches(error(4), 4.32e-3));
  BOOST_TEST(matches(error(8), 1.57e-7));
  BOOST_TEST(error(16) < 4.5e-16);
}

BOOST_AUTO_TEST_CASE(published_table_of_a_function_that_jumps) {
  // Integrates e^x on [0, 2 pi]: at the jump the rule takes the mean of both sides.
  const double last = std::exp(2.0 * pi);
  const auto error = [&](Index n) {
    const double sum =
        integrate(n, [&](double t) { return t == 0.0 ? 0.5 * (1.0 + last) : std::exp(t); });
    return sum / (last - 1.0) - 1.0;
  };
  BOOST_TEST(matches(error(4), 1.98e-1));
  BOOST_TEST(matches(error(8), 5.09e-2));
  BOOST_TEST(matches(error(16), 1.28e-2));
  BOOST_TEST(matches(error(32), 3.21e-3));
}
