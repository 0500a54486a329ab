// Measures the speed of the sums and of the solver on this machine. Every time is the least of
// several measured times, and every ratio compares times of the same run. The program never fails
// because of a low speed.
#include <fstream>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <omp.h>

#include "cli/build_info.hpp"
#include "close_evaluation.hpp"
#include "direct_sum.hpp"
#include "fast_sum.hpp"
#include "fma_peak.hpp"
#include "table.hpp"
#include "taylor_green.hpp"
#include "waiting.hpp"

namespace stokesbook {

namespace {

std::string machine() {
  const BuildInfo build = build_info();
  std::ostringstream text;
  text << "processor  " << machine_name() << "\nthreads    " << omp_get_max_threads()
       << "\ncompiler   " << build.compiler << "\nflags      " << build.flags << '\n';
  return text.str();
}

std::vector<Table> run_benchmarks(bool quick, const std::string& program) {
  const double budget = quick ? 0.05 : 0.5;
  std::vector<Table> tables;
  const auto add = [&](const Table& table) {
    print(std::cout, table);
    tables.push_back(table);
  };
  const double peak = fma_peak(budget);
  add({"Peak of one core, independent fused multiply-adds",
       {"threads", "GFlop/s"},
       {{1.0, 1e-9 * peak}},
       ""});
  add(time_direct_sum(peak, quick ? 2048 : 16384, budget));
  add(time_storage(0.5 * budget));
  add(time_fast_sum(quick ? 81 : 784, budget));
  add(time_break_even(0.1 * budget));
  add(time_close_evaluation(0.5 * budget));
  add(time_near_storage(0.5 * budget));
  add(time_taylor_green(budget));
  if (!quick) add(time_waiting(program));
  return tables;
}

}  // namespace

}  // namespace stokesbook

int main(int argc, char** argv) {
  CLI::App app{"Measures the speed of the sums and of the solver on this machine"};
  std::string csv, html;
  bool quick = false;
  app.add_option("--csv", csv, "file to which the numbers are written, too");
  app.add_option("--html", html, "file to which tables and figures are written, too");
  app.add_flag("--quick", quick, "fewer sizes and repeats");
  int solves = 0;
  app.add_option("--solves", solves, "number of solves to time; the program does nothing else")
      ->group("");
  CLI11_PARSE(app, argc, argv);
  if (solves > 0) {
    const stokesbook::WorkTime time = stokesbook::solve_often(solves);
    std::cout << time.wall << ' ' << time.cpu << '\n';
    return 0;
  }
  std::cout << stokesbook::machine();
  const std::vector<stokesbook::Table> tables = stokesbook::run_benchmarks(quick, argv[0]);
  const auto write = [](const std::string& path, const auto& write_to) {
    if (path.empty()) return true;
    std::ofstream file(path);
    write_to(file);
    file.close();
    if (!file) std::cerr << "stokes_bench: cannot write " << path << '\n';
    return static_cast<bool>(file);
  };
  const bool written = write(csv, [&](std::ostream& out) { stokesbook::write_csv(out, tables); }) &&
                       write(html, [&](std::ostream& out) {
                         stokesbook::write_page(out, stokesbook::machine(), tables);
                       });
  return written ? 0 : 3;
}
