// Tests the table of a sweep, for runs whose files the test writes.

#include "sweep/results.hpp"

#include <cmath>

#include "sweep/sweep_folder.hpp"
#include "sweep_files.hpp"
#include "text/number_text.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

constexpr const char* sweep_text =
    "seeds = [1, 2, 3]\n"
    "[[axes]]\nkey = 'bodies.0.shape.semi_axes'\nname = 'axes'\nvalues = [[1.0, 0.5], [2.0, 1.0]]\n"
    "[[collect]]\ntable = 'rheology.csv'\ncolumn = 's12'\naverage = [0.0, 2.0]\n";

/// Writes a run that is done and whose s12 grows from 0 to `twice`.
void write_run(const Folder& folder, std::size_t task, const std::string& twice) {
  const std::string name = TaskFolder::name(task);
  folder.write(name + "/run.json", "{\"exit_status\": 0}\n");
  folder.write(name + "/rheology.csv", "t,s12\n0,0\n2," + twice + "\n");
}

std::vector<Task> all_tasks(const Sweep& sweep) {
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < task_count(sweep); ++k) tasks.push_back(task_of(sweep, k));
  return tasks;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(results)

BOOST_AUTO_TEST_CASE(runs_are_found_by_the_numbers_of_their_tasks) {
  const Folder folder;
  const Sweep sweep = folder.sweep(sweep_text);
  std::vector<Task> tasks = all_tasks(sweep);
  std::swap(tasks[0].number, tasks[5].number);
  write_run(folder, 5, "2");
  const std::vector<ResultRow> rows = collect(folder.path(), sweep, tasks);
  BOOST_TEST(rows[0].runs == 1);
  BOOST_TEST(rows[1].runs == 0);
}

BOOST_AUTO_TEST_CASE(runs_that_are_done_count) {
  const Folder folder;
  const Sweep sweep = folder.sweep(sweep_text);
  write_run(folder, 0, "2");
  write_run(folder, 1, "4");
  write_run(folder, 2, "12");
  write_run(folder, 4, "14");
  folder.write(TaskFolder::name(3) + "/failure.txt", "no convergence");
  const std::vector<ResultRow> rows = collect(folder.path(), sweep, all_tasks(sweep));
  BOOST_TEST(rows.size() == 2U);
  BOOST_TEST(rows[0].runs == 3);
  BOOST_TEST(rows[0].estimates[0].mean == 3.0);
  BOOST_TEST(rows[0].estimates[0].standard_error == std::sqrt(14.0 / 6.0),
             boost::test_tools::tolerance(1e-15));
  BOOST_TEST(rows[1].values[0] == "[2.0, 1.0]");
  BOOST_TEST(rows[1].runs == 1);
  BOOST_TEST(rows[1].failed == 1);
  BOOST_TEST(rows[1].unfinished == 1);
  BOOST_TEST(rows[1].estimates[0].mean == 7.0);
}

// The average of a single run has the error of its mean over time.
BOOST_AUTO_TEST_CASE(a_single_run_has_errors_over_time) {
  const Folder folder;
  const Sweep sweep = folder.sweep(sweep_text);
  std::string rows = "t,s12\n";
  std::vector<double> t, y;
  for (int k = 0; k <= 20; ++k) {
    t.push_back(0.1 * k);
    y.push_back(std::sin(3.0 * k));
    rows += exact_number(t.back()) + "," + exact_number(y.back()) + "\n";
  }
  folder.write(TaskFolder::name(0) + "/run.json", "{\"exit_status\": 0}\n");
  folder.write(TaskFolder::name(0) + "/rheology.csv", rows);
  const MeanEstimate found = collect(folder.path(), sweep, all_tasks(sweep))[0].estimates[0];
  const MeanEstimate expected = mean_over_time(t, y, 0.0, 2.0);
  BOOST_TEST(found.standard_error > 0.0);
  BOOST_TEST(found.standard_error == expected.standard_error);
  BOOST_TEST(found.interval == expected.interval);
}

BOOST_AUTO_TEST_CASE(tables) {
  const Folder folder;
  const Sweep sweep = folder.sweep(sweep_text);
  for (const std::size_t k : {0U, 1U, 2U})
    write_run(folder, k, k == 2 ? "0.40000000000000002" : "0.2");
  const std::vector<ResultRow> rows = collect(folder.path(), sweep, all_tasks(sweep));
  const std::string csv = to_csv(sweep, rows);
  // The last digits of the error depend on whether the compiler fuses multiplications and
  // additions.
  BOOST_TEST(
      csv.starts_with("axes,runs,failed,unfinished,s12,s12_standard_error,s12_interval\n"
                      "\"[1.0, 0.5]\",3,0,0,0.13333333333333333,0.033333333333333"));
  BOOST_TEST(csv.ends_with("\"[2.0, 1.0]\",0,0,3,nan,nan,nan\n"));
  BOOST_TEST(to_text(sweep, rows) ==
             "        axes  runs  failed  unfinished               s12\n"
             "  [1.0, 0.5]     3       0           0  0.133333 +- 0.14\n"
             "  [2.0, 1.0]     0       0           3               nan\n");
}

BOOST_AUTO_TEST_SUITE_END()
