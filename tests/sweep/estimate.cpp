// Tests means and their error bars against exact values and against random samples.

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "sweep/results.hpp"

using namespace stokesbook;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(estimates)

BOOST_AUTO_TEST_CASE(two_values) {
  const std::array values{1.0, 4.0};
  const auto [mean, error, interval] = estimate_mean(values);
  BOOST_TEST(mean == 2.5);
  BOOST_TEST(error == 1.5, tolerance(1e-15));  // half the distance of the two values
  // With one degree of freedom Student's distribution is Cauchy's, of quantile tan(pi (p - 1/2)).
  BOOST_TEST(interval == 1.5 * std::tan(0.475 * std::numbers::pi), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(three_values) {
  const std::array values{1.0, 2.0, 6.0};
  const auto [mean, error, interval] = estimate_mean(values);
  BOOST_TEST(mean == 3.0);
  BOOST_TEST(error == std::sqrt(14.0 / 6.0), tolerance(1e-15));
  // With two degrees of freedom the quantile is a / sqrt(2 p (1 - p)), a = 2 p - 1.
  BOOST_TEST(interval == error * 0.95 / std::sqrt(2.0 * 0.975 * 0.025), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(what_too_few_runs_do_not_define) {
  const std::array one{5.0};
  BOOST_TEST(estimate_mean(one).mean == 5.0);
  BOOST_TEST(std::isnan(estimate_mean(one).standard_error));
  BOOST_TEST(std::isnan(estimate_mean(one).interval));
  BOOST_TEST(std::isnan(estimate_mean({}).mean));
}

BOOST_AUTO_TEST_CASE(intervals_hold_the_mean_as_often_as_they_say) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(3.0, 2.0);
  constexpr int samples = 20000;
  int held = 0;
  for (int k = 0; k < samples; ++k) {
    std::array<double, 4> values{};
    for (double& x : values) x = normal(random);
    const MeanEstimate estimate = estimate_mean(values);
    held += std::abs(estimate.mean - 3.0) <= estimate.interval ? 1 : 0;
  }
  // The tolerance is four standard deviations of the count. An interval of two standard errors
  // would contain the mean in 86 % of the samples only.
  const double deviation = std::sqrt(0.95 * 0.05 / samples);
  BOOST_TEST(std::abs(static_cast<double>(held) / samples - 0.95) < 4.0 * deviation);
}

namespace {

// Returns n values of an autoregressive process of order one with variance one, whose neighbours
// have the correlation phi, beginning with its stationary distribution.
std::vector<double> autoregressive(double phi, std::size_t n, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> values;
  double x = normal(random);
  for (std::size_t k = 0; k < n; ++k) {
    values.push_back(x);
    x = phi * x + std::sqrt(1.0 - phi * phi) * normal(random);
  }
  return values;
}

std::vector<double> times_of(std::size_t n) {
  std::vector<double> t(n);
  for (std::size_t k = 0; k < n; ++k) t[k] = 0.1 * static_cast<double>(k);
  return t;
}

// Counts how often the interval of the mean over time contains the mean, which is 3, per sample.
double coverage(auto series, std::size_t n, int samples) {
  std::mt19937_64 random(7);
  const std::vector<double> t = times_of(n);
  int held = 0;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<double> y = series(random);
    for (double& value : y) value += 3.0;
    const MeanEstimate estimate = mean_over_time(t, y, t.front(), t.back());
    held += std::abs(estimate.mean - 3.0) <= estimate.interval ? 1 : 0;
  }
  return static_cast<double>(held) / samples;
}

}  // namespace

// The coverage is that which mean_over_time() promises, up to three standard deviations of the
// count of 400 samples, 0.03. Errors that took the values for independent ones would contain the
// mean in 74, 35 and 16 of 100 samples for the correlations 0.5, 0.9 and 0.98.
BOOST_AUTO_TEST_CASE(intervals_over_time_know_of_correlation) {
  constexpr int samples = 400;
  for (const auto& process : {std::pair(0.0, 100U), std::pair(0.5, 300U), std::pair(0.9, 100U),
                              std::pair(0.9, 1000U), std::pair(0.98, 1000U)}) {
    const double phi = process.first;
    const unsigned n = process.second;
    const double held = coverage(
        [&](std::mt19937_64& random) { return autoregressive(phi, n, random); }, n, samples);
    BOOST_TEST(held > 0.88, phi << " " << n << " " << held);
    BOOST_TEST(held < 0.995, phi << " " << n << " " << held);
  }
  // The sum of a fast and a slow process: the correlation of neighbours shows the fast one only.
  const double both = coverage(
      [](std::mt19937_64& random) {
        std::vector<double> y = autoregressive(0.2, 1000, random);
        const std::vector<double> slow = autoregressive(0.97, 1000, random);
        for (std::size_t k = 0; k < y.size(); ++k) y[k] = 3.0 * y[k] + slow[k];
        return y;
      },
      1000, samples);
  BOOST_TEST(both > 0.88, both);
}

// The variance of the mean of n values is (1 + phi) / (1 - phi) / n for large n.
BOOST_AUTO_TEST_CASE(errors_over_time_have_the_right_size) {
  constexpr std::size_t n = 20000;
  constexpr double phi = 0.9;
  std::mt19937_64 random(11);
  const std::vector<double> t = times_of(n);
  double squares = 0.0;
  for (int sample = 0; sample < 50; ++sample) {
    const std::vector<double> y = autoregressive(phi, n, random);
    const double error = mean_over_time(t, y, t.front(), t.back()).standard_error;
    squares += error * error / 50.0;
  }
  // With 32 blocks each square has a relative deviation of 0.3, and their mean one of 0.05. The
  // correction of rho, which never makes an error smaller, adds 0.1 to the mean.
  BOOST_TEST(squares * n * (1.0 - phi) / (1.0 + phi) > 0.85);
  BOOST_TEST(squares * n * (1.0 - phi) / (1.0 + phi) < 1.4);
}

BOOST_AUTO_TEST_CASE(means_over_time_without_errors) {
  const std::vector<double> t = times_of(10);
  const std::vector<double> constant(10, 4.0);
  BOOST_TEST(mean_over_time(t, constant, 0.0, t.back()).mean == 4.0, tolerance(1e-15));
  BOOST_TEST(mean_over_time(t, constant, 0.0, t.back()).standard_error < 1e-15);
  BOOST_TEST(std::isnan(mean_over_time(t, constant, 0.0, 0.55).standard_error));  // 6 times
}

BOOST_AUTO_TEST_SUITE_END()
