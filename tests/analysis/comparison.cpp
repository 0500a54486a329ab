// Tests differences of runs against planted ones, and the judgement of growth against known laws.
#include "analysis/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "record/atomic_file.hpp"
#include "synthetic_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

double zero(double) {
  return 0.0;
}

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

/// Samples a function at t = 0, 0.1, ..., 20 and judges its growth.
Growth growth_of(double (*error)(double), double bound = 1e-2) {
  std::vector<double> t, errors;
  for (int k = 0; k <= 200; ++k) {
    t.push_back(0.1 * k);
    errors.push_back(error(t.back()));
  }
  return judge_growth(t, errors, bound);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(comparison)

BOOST_AUTO_TEST_CASE(a_run_equals_itself) {
  const Run run = run_of(disks(3), {0, 1, 2}, zero);
  const Comparison same = compare(run, run);
  BOOST_TEST(same.t.size() == 3u);
  BOOST_TEST(same.differences.size() == 10u);  // without torque ratio, order, uniform velocity
  for (const Difference& difference : same.differences) {
    BOOST_TEST(std::ranges::max(difference.errors) == 0.0);
  }
  BOOST_TEST(same.rheology() == 0.0);
}

BOOST_AUTO_TEST_CASE(a_planted_difference_has_its_size_and_its_times) {
  const Scene scene = disks(2);
  const Run run = run_of(
      scene, {0, 1, 2, 4}, [](double t) { return 0.03 * t; }, 3.3);
  const Run reference = run_of(scene, {0, 0.5, 1, 2.5, 4}, zero);
  const Comparison found = compare(run, reference);
  BOOST_TEST(found.t == (std::vector<double>{0, 1, 4}), boost::test_tools::per_element());
  for (std::size_t k = 0; k < 3; ++k) {
    // 0.03 t in units of the radius 2.
    BOOST_TEST(found["positions"][k] == 0.015 * found.t[k], within_rounding);
    BOOST_TEST(found.trajectory[k] == 0.015 * found.t[k], within_rounding);
    BOOST_TEST(found["angles"][k] == 0.0);
    BOOST_TEST(found["stresslet"][k] == 0.1, within_rounding);
  }
  BOOST_TEST(found.rheology() == 0.1, within_rounding);
  BOOST_TEST(to_text(found).find("positions     0.06     4        0.06     2") !=
             std::string::npos);
  BOOST_TEST(draw(found).find(">positions<") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_body_with_the_largest_error_counts) {
  const Run reference = run_of(disks(3), {0, 1}, zero);
  for (std::size_t body = 0; body < 3; ++body) {
    Run run = reference;
    run.bodies.columns[4][3 + body] += 0.25;  // theta at t = 1
    const Comparison found = compare(run, reference);
    BOOST_TEST(found["angles"][0] == 0.0);
    BOOST_TEST(found["angles"][1] == 0.25, within_rounding);
    BOOST_TEST(found.trajectory[1] == 0.25, within_rounding);
  }
}

BOOST_AUTO_TEST_CASE(runs_that_cannot_be_compared) {
  const Run run = run_of(disks(2), {0, 1}, zero);
  BOOST_TEST(message_of([&] {
               compare(run, run_of(disks(3), {0, 1}, zero));
             }) == "run: must have as many bodies and walls as run");
  BOOST_TEST(message_of([&] {
               compare(run, run_of(disks(2), {0.5, 2}, zero));
             }).starts_with("run: has no written time in common with run"));
  BOOST_TEST(message_of([&] {
               compare(run, run)["viscosity"];
             }).starts_with("quantity viscosity: must be one that the scene defines: positions,"));
  BOOST_TEST(message_of([&] {
               read_run("no_such_folder");
             }).starts_with("no_such_folder: must be the folder of a run"));
}

BOOST_AUTO_TEST_CASE(exponential_growth_is_found_with_its_rate) {
  const Growth chaos = growth_of([](double t) { return std::min(1.0, 1e-8 * std::exp(1.3 * t)); });
  BOOST_REQUIRE(chaos.rate.has_value());
  BOOST_TEST(*chaos.rate == 1.3, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(chaos.at_end == 1.0);
  BOOST_REQUIRE(chaos.exceeds.has_value());
  BOOST_TEST(*chaos.exceeds == std::log(1e6) / 1.3, boost::test_tools::tolerance(0.01));
  // An error that oscillates while it grows.
  const Growth oscillating =
      growth_of([](double t) { return 1e-8 * std::exp(0.8 * t) * std::abs(std::sin(3.0 * t)); });
  BOOST_REQUIRE(oscillating.rate.has_value());
  BOOST_TEST(*oscillating.rate == 0.8, boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(other_growth_is_not_exponential) {
  for (const auto error :
       {+[](double t) { return 1e-6 * t; }, +[](double t) { return 1e-8 * t * t * t; },
        +[](double) { return 1e-6; }, +[](double) { return 0.0; },
        +[](double t) { return t < 10.0 ? 1e-8 : 1e-5; },
        +[](double t) { return 1e-6 * std::exp(0.1 * t); },
        +[](double t) { return t < 5.0 ? 0.0 : 1e-13 * std::pow(t, 6.0); }}) {
    const Growth growth = growth_of(error);
    BOOST_TEST(!growth.rate.has_value());
    BOOST_TEST(!growth.exceeds.has_value());
    BOOST_TEST(growth.at_end == error(20.0), within_rounding);
  }
}

BOOST_AUTO_TEST_SUITE_END()
