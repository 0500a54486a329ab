// Checks the output of a study: tables, CSV and the numbers of the chapters.

#include <regex>
#include <sstream>

#include <boost/test/unit_test.hpp>

#include "study/report.hpp"
#include "study/tables.hpp"
#include "synthetic.hpp"

using namespace stokesbook::study;
using namespace stokesbook::test;

namespace {

StudyResult sample_result() {
  std::ostringstream progress;
  return run(sample_study(), Size::quick, progress);
}

const std::string here = "stokesbook 0.1, a machine";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(reports)

BOOST_AUTO_TEST_CASE(csv_restores_every_number) {
  std::istringstream csv(to_csv(sample_result()));
  std::string row;
  std::getline(csv, row);
  BOOST_TEST(row == "experiment,line,x,error,unknowns,operations,seconds,role");
  std::getline(csv, row);
  BOOST_TEST(row.starts_with("orders,method,8,"));
  BOOST_TEST(row.ends_with(",nan,nan,nan,used"));
  BOOST_TEST(std::stod(row.substr(std::string("orders,method,8,").size())) == 3.0 / 64.0);
  int rows = 1, controls = 0;
  for (; std::getline(csv, row); ++rows) controls += row.ends_with(",control") ? 1 : 0;
  BOOST_TEST(rows == 15);
  BOOST_TEST(controls == 5);
}

BOOST_AUTO_TEST_CASE(aliases_carry_the_numbers) {
  const std::string aliases = to_aliases(sample_result());
  BOOST_TEST(contains(aliases, "ALIASES += \"val_99_orders_method_16=0.0117\"\n"));
  BOOST_TEST(contains(aliases, "ALIASES += \"val_claim_99_1=2\"\n"));
  BOOST_TEST(contains(aliases, "ALIASES += \"val_claim_99_1_claimed=2\"\n"));
  StudyResult thirds = sample_result();
  thirds.experiments[0].lines[0].measurements[0].x = 1.0 / 3.0;
  BOOST_TEST(contains(to_aliases(thirds), "ALIASES += \"val_99_orders_method_0p333333="));
}

BOOST_AUTO_TEST_CASE(badges_show_measured_and_claimed_numbers) {
  const std::string badge =
      "ALIASES += \"badge_99_1=@htmlonly <a class=\\\"badge\\\" href=\\\"claims.html"
      "#claim_99_1\\\" title=\\\"a &lt; b &amp; c Claimed: ";
  const std::string orders = to_aliases(sample_result());
  BOOST_TEST(contains(orders, badge + "error = C N^-2. Measured: order 2 measured"));
  BOOST_TEST(
      contains(orders, ". Planted error detected.\\\">99.1: 2<small> claimed 2</small></a>"));
  Study study = sample_study();
  Line& line = study.experiments[0].lines[0];
  line.claim->law = AtMost{0.5};
  std::ostringstream progress;
  const std::string bound = to_aliases(run(study, Size::quick, progress));
  BOOST_TEST(contains(bound, "99.1: 0.0469<small> claimed &le;&nbsp;0.5</small>"));
  line.least = Size::full;
  const std::string left_out = to_aliases(run(study, Size::quick, progress));
  BOOST_TEST(
      contains(left_out, badge + "value &lt;= 0.5.\\\">99.1: full size only</a>@endhtmlonly\"\n"));
}

BOOST_AUTO_TEST_CASE(numbers_for_people) {
  BOOST_TEST(html_number(0.5) == "0.5");
  BOOST_TEST(html_number(-0.0) == "0");
  BOOST_TEST(html_number(1025.0) == "1025");
  BOOST_TEST(html_number(1025.5) == "1.03&middot;10<sup>3</sup>");
  BOOST_TEST(html_number(1.234e-12) == "1.23&middot;10<sup>-12</sup>");
  BOOST_TEST(html_number(unmeasured) == "&ndash;");
}

BOOST_AUTO_TEST_CASE(tables_show_what_failed) {
  Study study = sample_study();
  study.experiments[0].lines[0].claim->law = Algebraic{3.0};
  std::ostringstream progress;
  const StudyResult result = run(study, Size::quick, progress);
  BOOST_TEST(contains(progress.str(), "99_1  fails"));
  BOOST_TEST(contains(convergence_table(result.experiments[0]), "<b>fails"));
  BOOST_TEST(contains(claims_list(result), "<b>fails"));
  BOOST_TEST(contains(claims_page({result}), "<b>fails</b>"));
}

BOOST_AUTO_TEST_CASE(cells_of_points_that_are_left_out_are_grey) {
  Study study = sample_study();
  Window& window = study.experiments[0].lines[0].claim->window;
  window = {.from = 16.0, .to = 64.0};
  std::ostringstream progress;
  const std::string table = convergence_table(run(study, Size::quick, progress).experiments[0]);
  const std::string start = "<td class=\"left-out\">";
  const std::regex row("<tr><th>([0-9]+)</th>([^]*?)</tr>"), grey(start);
  int rows = 0;
  for (std::sregex_iterator at(table.begin(), table.end(), row), end; at != end; ++at, ++rows) {
    const double x = std::stod((*at)[1]);
    const std::string cells = (*at)[2].str();
    const bool left_out = x < window.from || x > window.to;
    // The first line has the cells of error and order; the second line has no claim.
    BOOST_TEST(cells.starts_with(start) == left_out);
    BOOST_TEST(std::distance(std::sregex_iterator(cells.begin(), cells.end(), grey), end) ==
               (left_out ? 2 : 0));
  }
  BOOST_TEST(rows == 5);
}

BOOST_AUTO_TEST_CASE(tables_and_pages_say_the_same_of_a_claim) {
  const auto check_said = [](const Study& study, const std::string& text) {
    std::ostringstream progress;
    const StudyResult result = run(study, Size::quick, progress);
    BOOST_TEST(!result.holds());
    BOOST_TEST(contains(convergence_table(result.experiments[0]), "<b>" + text + "</b></td>"));
    BOOST_TEST(contains(claims_list(result), ": <b>" + text + "</b><br>\n"));
    BOOST_TEST(contains(claims_page({result}), ": <b>" + text + "</b>\n"));
  };
  Study too_few = sample_study();
  too_few.experiments[0].lines[0].claim->window.from = 1e9;
  check_said(too_few, "inconclusive");
  Study loose = sample_study();
  loose.experiments[0].lines[0].claim->law = Algebraic{2.0, 100.0};
  check_said(loose, "holds, but its planted error is not detected");
}

BOOST_AUTO_TEST_CASE(tables_have_costs_where_they_were_measured) {
  StudyResult result = sample_result();
  BOOST_TEST(!contains(convergence_table(result.experiments[0]), "cost"));
  for (Measurement& point : result.experiments[0].lines[0].measurements) {
    point.unknowns = 7.0 * point.x;
  }
  const std::string table = convergence_table(result.experiments[0]);
  BOOST_TEST(contains(table, "Cost: unknowns."));
  BOOST_TEST(contains(table, "<td>448</td><td>0.0469</td><td>1</td><td>&ndash;</td></tr>"));
  // A cost that repeats the first column is left out.
  for (LineResult& line : result.experiments[0].lines) {
    for (Measurement& point : line.measurements) point.unknowns = point.x;
  }
  BOOST_TEST(!contains(convergence_table(result.experiments[0]), "Cost"));
}

BOOST_AUTO_TEST_CASE(tables_of_cases_have_no_orders) {
  StudyResult result = sample_result();
  const auto table = [&](Axes axes) {
    result.experiments[0].experiment.axes = axes;
    return convergence_table(result.experiments[0]);
  };
  BOOST_TEST(contains(table(Axes::log_log), "<th>order</th>"));
  BOOST_TEST(contains(table(Axes::semi_log), "<th>rate</th>"));
  for (const Axes axes : {Axes::no_law, Axes::nominal}) {
    const std::string without = table(axes);
    BOOST_TEST(contains(without, "<th>value</th>"));
    BOOST_TEST(!contains(without, "<th>order</th>"));
    BOOST_TEST(!contains(without, "<th>rate</th>"));
  }
  result.experiments[0].experiment.error = "relative error";
  BOOST_TEST(contains(table(Axes::nominal), "<th>error</th>"));
}

BOOST_AUTO_TEST_CASE(what_only_the_full_size_measures_is_said) {
  Study study = sample_study();
  const Measure large = [](Size size) {
    return size == Size::full ? std::vector<Measurement>{{.x = 1.0, .error = 2.0}}
                              : std::vector<Measurement>{};
  };
  Experiment& experiment = study.experiments.emplace_back();
  experiment.key = "large";
  experiment.lines = {{.key = "line", .label = "a line", .measure = large}};
  std::ostringstream progress;
  const std::string quick = study_page(run(study, Size::quick, progress), here);
  BOOST_TEST(contains(quick, "_large_table.html"));
  BOOST_TEST(!contains(quick, "_large_figure.html"));
  const std::string full = study_page(run(study, Size::full, progress), here);
  BOOST_TEST(contains(full, "_large_figure.html"));
}

BOOST_AUTO_TEST_CASE(text_is_escaped) {
  BOOST_TEST(contains(claims_list(sample_result()), "a &lt; b &amp; c"));
  BOOST_TEST(contains(claims_page({sample_result()}), "@anchor claim_99_1"));
}

BOOST_AUTO_TEST_CASE(claims_lead_to_their_measurements) {
  BOOST_TEST(contains(claims_page({sample_result()}), "@ref study_sample_orders"));
  const std::string page = study_page(sample_result(), "a <fast> one");
  BOOST_TEST(contains(page, "{#study_sample_orders}"));
  BOOST_TEST(contains(page, "@htmlinclude sample_orders_figure.html"));
  BOOST_TEST(contains(page, "a &lt;fast> one"));
}

BOOST_AUTO_TEST_CASE(pages_lead_to_their_chapter) {
  BOOST_TEST(contains(claims_page({sample_result()}), "@ref chapter_99"));
  BOOST_TEST(contains(study_page(sample_result(), {}), "@ref chapter_99"));
}

BOOST_AUTO_TEST_SUITE_END()
