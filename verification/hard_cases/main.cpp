// Runs the hard cases of the book, prints the results, and fails if a result is not as required: an
// answer outside its tolerance, or an answer in place of a refusal.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>
#include <omp.h>

#include "report.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::verification::hard_cases {

namespace {

constexpr int exit_case_fails = 2, exit_io = 3;

// Checks the test itself: the test must reject an answer outside its tolerance, and an answer in
// place of a refusal.
bool rejects_bad_answers() {
  Scene pair = circles_in_extension(0.1, 0.3);
  for (Body& disk : pair.bodies) disk.n_nodes = 24;
  const Finding rough = solve(pair, [](const Solution& solution) {
    return std::abs(solution.motions[1].velocity -
                    test::CirclePair{1.0, 0.1}.speed_in_extension(1.0));
  });
  Finding demanding = rough;
  demanding.tolerance = 1e-3 * rough.error;
  const HardCase answer{"", "", {}}, refusal{"", "", {}, Due::refusal};
  return is_met(answer, rough) && !is_met(answer, demanding) && !is_met(refusal, rough);
}

Row row_of(const HardCase& hard) {
  using clock = std::chrono::steady_clock;
  const clock::time_point start = clock::now();
  const Finding finding = hard.find();
  return {hard, finding, std::chrono::duration<double>(clock::now() - start).count()};
}

int run_all(const std::string& html) {
  std::vector<Row> rows;
  for (const auto& cases :
       {answers(), crowds(), sums(), motions(), contacts(), problems(), refusals()}) {
    for (const HardCase& hard : cases) {
      rows.push_back(row_of(hard));
      print(std::cout, rows.back());
    }
  }
  std::ranges::stable_sort(rows, {}, [](const Row& row) { return row.hard.chapter; });
  if (!html.empty()) {
    std::ofstream file(html);
    write_table(file, rows);
    file.close();
    if (!file) {
      std::cerr << "stokes_hard_cases: cannot write " << html << '\n';
      return exit_io;
    }
  }
  const auto failed =
      std::ranges::count_if(rows, [](const Row& row) { return !is_met(row.hard, row.finding); });
  const bool are_controls_rejected = rejects_bad_answers();
  std::cout << rows.size() - static_cast<std::size_t>(failed) << " of " << rows.size()
            << " results are as required"
            << (are_controls_rejected ? "\n"
                                      : "; the controls FAILED: a bad answer was accepted\n");
  return failed == 0 && are_controls_rejected ? 0 : exit_case_fails;
}

}  // namespace

}  // namespace stokesbook::verification::hard_cases

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  CLI::App app{"Runs the hard cases of the book, and shows how this build handles them"};
  std::string html;
  app.add_option("--html", html, "file to which the table is written, too");
  CLI11_PARSE(app, argc, argv);
  return stokesbook::verification::hard_cases::run_all(html);
}
