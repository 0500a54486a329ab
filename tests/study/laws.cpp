// Checks the verdicts on synthetic errors of known order, rate and floor.

#include <limits>
#include <random>

#include <boost/test/unit_test.hpp>

#include "synthetic.hpp"

using namespace stokesbook::study;
using namespace stokesbook::test;

namespace {

Outcome outcome(const Law& law, const std::vector<Measurement>& measurements,
                const Window& window = {}) {
  return check(claim_of(law, window), measurements).outcome;
}

auto power(double order, double floor = 0.0) {
  return [=](double x) { return 5.0 * std::pow(x, -order) + floor; };
}

auto exponential(double rate, double floor = 0.0) {
  return [=](double x) { return 0.3 * std::exp(-rate * x) + floor; };
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

BOOST_TEST_DONT_PRINT_LOG_VALUE(Outcome)

BOOST_AUTO_TEST_SUITE(laws)

BOOST_AUTO_TEST_CASE(algebraic_has_two_sides) {
  const Algebraic second{2.0, 0.15};
  BOOST_TEST(outcome(second, doubling(5, power(2.0))) == Outcome::holds);
  BOOST_TEST(outcome(second, doubling(5, power(1.9))) == Outcome::holds);
  BOOST_TEST(outcome(second, doubling(5, power(1.8))) == Outcome::fails);
  BOOST_TEST(outcome(second, doubling(5, power(2.2))) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(fit_returns_the_order) {
  const Verdict verdict = check(claim_of(Algebraic{2.0}), doubling(5, power(2.0)));
  BOOST_TEST(verdict.measured == 2.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(floor_is_left_out_of_a_fit) {
  const std::vector<Measurement> measurements = doubling(12, power(4.0, 1e-9));
  BOOST_TEST(outcome(Algebraic{4.0}, measurements) == Outcome::fails);
  const Verdict verdict = check(claim_of(Algebraic{4.0}, {.floor = 1e-9}), measurements);
  BOOST_TEST(verdict.outcome == Outcome::holds);
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    BOOST_TEST(verdict.used[i] == (measurements[i].error >= 1e-8));
  }
}

BOOST_AUTO_TEST_CASE(window_leaves_out_what_is_not_asymptotic) {
  const auto settles = [](double x) { return 1.0 / (x * x + 400.0); };
  BOOST_TEST(outcome(Algebraic{2.0}, doubling(8, settles)) == Outcome::fails);
  BOOST_TEST(outcome(Algebraic{2.0}, doubling(8, settles), {.from = 64.0}) == Outcome::holds);
  BOOST_TEST(outcome(Algebraic{2.0}, doubling(8, settles), {.to = 64.0}) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(errors_that_grow_have_a_power) {
  const Claim claim = claim_of(Algebraic{-1.5});
  const Verdict growing = check(claim, doubling(8, power(-1.5)));
  BOOST_TEST((growing.outcome == Outcome::holds));
  BOOST_TEST(growing.measured == 1.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(claimed_number(claim.law) == 1.5);
  BOOST_TEST(growing.explanation == "power 1.5 measured, 1.5 +- 0.15 claimed");
  BOOST_TEST(outcome(claim.law, doubling(8, power(1.5))) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(two_points_are_inconclusive) {
  const Verdict few = check(claim_of(Algebraic{2.0}), doubling(2, power(2.0)));
  BOOST_TEST(few.explanation == "2 points in the window, 3 needed");
  BOOST_TEST(outcome(Algebraic{2.0}, doubling(2, power(2.0))) == Outcome::inconclusive);
  BOOST_TEST(outcome(Algebraic{2.0}, doubling(8, power(2.0)), {.floor = 1e-2}) ==
             Outcome::inconclusive);
  for (const Law& law :
       {Law{Geometric{1.0}}, Law{Superalgebraic{1.0}}, Law{Floor{1.0}}, Law{Identity{1.0}},
        Law{AtMost{1.0}}, Law{Cost{1.0}}, Law{ErrorBelowTolerance{1.0, 0.0}}}) {
    BOOST_TEST(outcome(law, doubling(2, exponential(1.0))) == Outcome::inconclusive);
  }
}

BOOST_AUTO_TEST_CASE(errors_that_are_not_finite_fail) {
  const auto broken = [](double x) { return x > 30.0 ? not_a_number : 1.0 / x; };
  for (const Law& law : {Law{Algebraic{1.0}}, Law{Identity{1.0}}, Law{Floor{0.05}},
                         Law{ErrorBelowTolerance{1.0, 0.0}}}) {
    BOOST_TEST(outcome(law, doubling(5, broken)) == Outcome::fails);
  }
}

BOOST_AUTO_TEST_CASE(zero_errors_have_no_order) {
  BOOST_TEST(outcome(Algebraic{2.0}, doubling(5, [](double) { return 0.0; })) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(geometric_has_two_sides) {
  const auto measurements = [](double rate) {
    return stepping(4, 4, 10, exponential(rate, 1e-15));
  };
  const Window window{.floor = 1e-15};
  BOOST_TEST(outcome(Geometric{0.5}, measurements(0.5), window) == Outcome::holds);
  BOOST_TEST(outcome(Geometric{0.5}, measurements(0.45), window) == Outcome::fails);
  BOOST_TEST(outcome(Geometric{0.5}, measurements(0.55), window) == Outcome::fails);
  BOOST_TEST(outcome(Geometric{0.5}, doubling(5, power(2.0))) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(geometric_with_a_known_power) {
  const auto measurements =
      stepping(10, 10, 5, [](double x) { return x * x * std::exp(-0.3 * x); });
  BOOST_TEST(outcome(Geometric{0.3}, measurements) == Outcome::fails);
  const Verdict verdict = check(claim_of(Geometric{0.3, 0.05, 2.0}), measurements);
  BOOST_TEST(verdict.measured == 0.3, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(superalgebraic_grows) {
  BOOST_TEST(outcome(Superalgebraic{6.0}, doubling(4, exponential(0.2))) == Outcome::holds);
  BOOST_TEST(outcome(Superalgebraic{60.0}, doubling(4, exponential(0.2))) == Outcome::fails);
  const auto settling = [](double x) { return std::pow(x, -8.0) + 1e-6 * std::pow(x, -2.0); };
  BOOST_TEST(outcome(Superalgebraic{1.0}, doubling(8, settling)) == Outcome::fails);
  // An error of zero has no order, and errors before and after a zero prove nothing about the
  // order.
  std::vector<Measurement> with_zero = doubling(5, exponential(0.2));
  const double errors[] = {1e-2, 1e-12, 0.0, 1e-13, 1e-16};
  for (std::size_t k = 0; k < with_zero.size(); ++k) with_zero[k].error = errors[k];
  BOOST_TEST(outcome(Superalgebraic{6.0}, with_zero) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(floor_has_two_sides) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.3, 3.0);
  const auto noise = doubling(9, [&](double) { return 1e-15 * uniform(random); });
  BOOST_TEST(outcome(Floor{1e-15, 10.0}, noise) == Outcome::holds);
  BOOST_TEST(outcome(Floor{1e-13, 10.0}, noise) == Outcome::fails);
  BOOST_TEST(outcome(Floor{1e-17, 10.0}, noise) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(identity_holds_at_every_point) {
  const auto one_bad = [](double x) { return x == 32.0 ? 1e-10 : 1e-15; };
  BOOST_TEST(outcome(Identity{1e-12}, doubling(5, one_bad)) == Outcome::fails);
  BOOST_TEST(outcome(Identity{1e-9}, doubling(5, one_bad)) == Outcome::holds);
}

BOOST_AUTO_TEST_CASE(at_most_bounds_every_point) {
  const auto counts = [](double x) { return x == 32.0 ? 9.0 : 2.0; };
  BOOST_TEST(outcome(AtMost{9.0}, doubling(5, counts)) == Outcome::holds);
  BOOST_TEST(outcome(AtMost{8.9}, doubling(5, counts)) == Outcome::fails);
  BOOST_TEST(outcome(AtMost{9.0}, doubling(5, counts), {.to = 16.0}) == Outcome::inconclusive);
  BOOST_TEST(law_text(AtMost{9.0}, "nodes N") == "value <= 9");
  BOOST_TEST(claimed_number(AtMost{9.0}) == 9.0);
}

BOOST_AUTO_TEST_CASE(cost_is_of_counted_operations) {
  std::vector<Measurement> measurements = doubling(6, power(2.0));
  BOOST_TEST(outcome(Cost{1.0}, measurements) == Outcome::fails);
  for (Measurement& point : measurements) point.operations = 7.0 * point.x;
  BOOST_TEST(outcome(Cost{1.0}, measurements) == Outcome::holds);
  BOOST_TEST(outcome(Cost{1.2}, measurements) == Outcome::fails);
  BOOST_TEST(outcome(Cost{0.8}, measurements) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(default_bands) {
  for (const double side : {-1.0, 1.0}) {
    const auto order = [&](double deviation) {
      return outcome(Algebraic{2.0}, doubling(5, power(2.0 + side * deviation)));
    };
    BOOST_TEST(order(0.14) == Outcome::holds);
    BOOST_TEST(order(0.16) == Outcome::fails);
    const auto rate = [&](double deviation) {
      const double fitted = 0.5 * (1.0 + side * deviation);
      return outcome(Geometric{0.5}, stepping(4, 4, 10, exponential(fitted)));
    };
    BOOST_TEST(rate(0.04) == Outcome::holds);
    BOOST_TEST(rate(0.06) == Outcome::fails);
    const auto cost = [&](double deviation) {
      std::vector<Measurement> measurements = doubling(6, power(2.0));
      for (Measurement& point : measurements) {
        point.operations = 7.0 * std::pow(point.x, 1.0 + side * deviation);
      }
      return outcome(Cost{1.0}, measurements);
    };
    BOOST_TEST(cost(0.04) == Outcome::holds);
    BOOST_TEST(cost(0.06) == Outcome::fails);
    const auto level = [&](double factor) {
      return outcome(Floor{1e-15},
                     doubling(5, [&](double) { return 1e-15 * std::pow(factor, side); }));
    };
    BOOST_TEST(level(9.0) == Outcome::holds);
    BOOST_TEST(level(11.0) == Outcome::fails);
  }
}

BOOST_AUTO_TEST_CASE(tolerance_is_met_and_not_far_outdone) {
  const auto asked = [](double factor) {
    return stepping(1e-8, 1e-8, 4, [=](double x) { return factor * x; });
  };
  const ErrorBelowTolerance law{1.0, 1e-3};
  BOOST_TEST(outcome(law, asked(0.1)) == Outcome::holds);
  BOOST_TEST(outcome(law, asked(1.1)) == Outcome::fails);
  BOOST_TEST(outcome(law, asked(1e-4)) == Outcome::fails);
}

BOOST_AUTO_TEST_CASE(local_slopes) {
  const std::vector<Measurement> measurements = doubling(4, power(3.0));
  const std::vector<double> orders = local_orders(measurements);
  BOOST_TEST(std::isnan(orders[0]));
  for (std::size_t i = 1; i < 4; ++i) {
    BOOST_TEST(orders[i] == 3.0, boost::test_tools::tolerance(1e-12));
  }
  const std::vector<double> to_zero =
      local_orders(std::vector<Measurement>{{.x = 8, .error = 1.0}, {.x = 16, .error = 0.0}});
  BOOST_TEST(std::isnan(to_zero[1]));
  const std::vector<double> rates = local_rates(stepping(2, 3, 4, exponential(0.7)));
  for (std::size_t i = 1; i < 4; ++i) {
    BOOST_TEST(rates[i] == 0.7, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(laws_as_text) {
  BOOST_TEST(law_text(Algebraic{2.0}, "N") == "error = C N^-2");
  BOOST_TEST(law_text(Algebraic{0.0}, "N") == "error = C");
  BOOST_TEST(law_text(Algebraic{-1.5}, "N") == "error = C N^1.5");
  BOOST_TEST(law_text(Geometric{0.5, 0.05, 1.0}, "N") == "error = C N exp(-0.5 N)");
  BOOST_TEST(law_text(ErrorBelowTolerance{2.0, 0.1}, "eps") == "0.1 eps <= error <= 2 eps");
  BOOST_TEST(law_text(ErrorBelowTolerance{2.0, 0.0}, "eps") == "error <= 2 eps");
}

BOOST_AUTO_TEST_SUITE_END()
