// Speed of the sums and of the solver on this machine. Every time is the least of several, and
// ratios are of times of one run: nothing here fails for being slow.
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>
#include <omp.h>

#include "cli/build_info.hpp"
#include "close_evaluation.hpp"
#include "direct_sum.hpp"
#include "fast_sum.hpp"
#include "fma_peak.hpp"
#include "table.hpp"
#include "taylor_green.hpp"

namespace stokesbook {

namespace {

void print_machine() {
  const BuildInfo build = build_info();
  std::cout << "processor  " << machine_name() << "\nthreads    " << omp_get_max_threads()
            << "\ncompiler   " << build.compiler << "\nflags      " << build.flags << '\n';
}

std::vector<Table> run_benchmarks(bool quick) {
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
  add(time_taylor_green(quick, budget));
  return tables;
}

}  // namespace

}  // namespace stokesbook

int main(int argc, char** argv) {
  CLI::App app{"Speed of the sums and of the solver on this machine"};
  std::string csv;
  bool quick = false;
  app.add_option("--csv", csv, "also write the numbers to a file");
  app.add_flag("--quick", quick, "fewer sizes and repeats");
  CLI11_PARSE(app, argc, argv);
  stokesbook::print_machine();
  const std::vector<stokesbook::Table> tables = stokesbook::run_benchmarks(quick);
  if (csv.empty()) return 0;
  std::ofstream file(csv);
  stokesbook::write_csv(file, tables);
  file.close();
  if (!file) {
    std::cerr << "stokes_bench: cannot write " << csv << '\n';
    return 3;
  }
  return 0;
}
