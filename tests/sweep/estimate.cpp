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

BOOST_AUTO_TEST_SUITE_END()
