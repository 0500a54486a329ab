// Checks a study as a whole: claims, controls, and reasons that make a study invalid.

#include <sstream>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "synthetic.hpp"

using namespace stokesbook::study;
using namespace stokesbook::test;

namespace {

StudyResult run_quietly(const Study& study) {
  std::ostringstream progress;
  return run(study, Size::quick, progress);
}

Line& first_line(Study& study) {
  return study.experiments[0].lines[0];
}

}  // namespace

BOOST_AUTO_TEST_SUITE(runs)

BOOST_AUTO_TEST_CASE(claim_holds_and_control_is_rejected) {
  const StudyResult result = run_quietly(sample_study());
  BOOST_TEST(result.holds());
  BOOST_TEST(result.experiments[0].lines[0].control->is_rejected());
  BOOST_TEST(!result.experiments[0].lines[1].verdict);
}

BOOST_AUTO_TEST_CASE(defective_method_fails) {
  Study study = sample_study();
  std::swap(first_line(study).measure, first_line(study).control->measure);
  BOOST_TEST(!run_quietly(study).holds());
}

BOOST_AUTO_TEST_CASE(control_that_passes_fails_the_study) {
  Study study = sample_study();
  first_line(study).control->measure = first_line(study).measure;
  const StudyResult result = run_quietly(study);
  BOOST_TEST((result.experiments[0].lines[0].verdict->outcome == Outcome::holds));
  BOOST_TEST(!result.holds());
}

BOOST_AUTO_TEST_CASE(control_without_enough_points_is_not_rejected) {
  Study study = sample_study();
  first_line(study).control->measure = [](Size) { return doubling(2, [](double x) { return x; }); };
  BOOST_TEST(!run_quietly(study).holds());
}

BOOST_AUTO_TEST_CASE(mistakes_are_found_before_anything_runs) {
  const auto refused = [](const auto& spoil) {
    Study study = sample_study();
    bool measured = false;
    for (Line& line : study.experiments[0].lines) {
      line.measure = [&measured](Size) {
        measured = true;
        return std::vector<Measurement>{};
      };
    }
    spoil(study);
    BOOST_CHECK_THROW(run_quietly(study), std::logic_error);
    BOOST_TEST(!measured);
  };
  refused([](Study& study) { first_line(study).control.reset(); });
  refused([](Study& study) { first_line(study).claim.reset(); });
  refused([](Study& study) { first_line(study).key = "with blank"; });
  refused([](Study& study) { first_line(study).claim->id = "98_1"; });
  refused([](Study& study) { study.experiments[0].key = ""; });
  refused([](Study& study) { study.experiments[0].lines[1].key = "method"; });
  refused([](Study& study) { study.experiments.push_back(study.experiments[0]); });
}

BOOST_AUTO_TEST_CASE(operations_that_are_counted_have_a_name) {
  Study study = sample_study();
  first_line(study).measure = [measure = first_line(study).measure](Size size) {
    std::vector<Measurement> measurements = measure(size);
    measurements[0].operations = 3.0;
    return measurements;
  };
  BOOST_CHECK_THROW(run_quietly(study), std::logic_error);
  study.experiments[0].operation = "products";
  BOOST_TEST(run_quietly(study).holds());
}

BOOST_AUTO_TEST_CASE(costs_that_were_measured) {
  StudyResult result = run_quietly(sample_study());
  BOOST_TEST(measured_costs(result.experiments[0]).empty());
  result.experiments[0].lines[1].measurements[2].seconds = 0.1;
  const auto costs = measured_costs(result.experiments[0]);
  BOOST_TEST_REQUIRE(costs.size() == 1u);
  BOOST_TEST(costs[0].name == "seconds on this machine");
}

BOOST_AUTO_TEST_SUITE_END()
