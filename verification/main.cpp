// Runs the studies of the methods: checks every claim of the book, and writes tables, figures and
// the numbers that the chapters quote.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include <CLI/CLI.hpp>
#include <omp.h>

#include "cli/build_info.hpp"
#include "record/atomic_file.hpp"
#include "studies.hpp"
#include "study/report.hpp"

namespace stokesbook {

namespace {

constexpr int exit_claim_fails = 2, exit_io = 3;

/// Returns all studies in reading order.
std::vector<study::Study> all_studies() {
  return {trapezoid_study(),       double_layer_study(),  closure_study(), null_space_study(),
          krylov_study(),          near_singular_study(), stress_study(),  fmm_study(),
          time_stepping_study(),   stiv_study(),          lcp_study(),     suspension_study(),
          preconditioning_study(), periodic_study()};
}

bool named(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

void drop_empty(std::vector<study::Study>& studies) {
  std::erase_if(studies, [](const study::Study& study) { return study.experiments.empty(); });
}

/// Keeps the experiments with these keys, and the studies that contain such an experiment. All
/// lines of a selected experiment run, even if the quick size would skip them.
void keep_named(std::vector<study::Study>& studies, const std::vector<std::string>& keys) {
  std::set<std::string> known;
  for (study::Study& study : studies) {
    for (const study::Experiment& experiment : study.experiments) known.insert(experiment.key);
    std::erase_if(study.experiments, [&](const study::Experiment& experiment) {
      return !named(keys, experiment.key);
    });
    if (keys.empty()) continue;
    for (study::Experiment& experiment : study.experiments) {
      for (study::Line& line : experiment.lines) line.least = study::Size::quick;
    }
  }
  drop_empty(studies);
  const CLI::IsMember one_of_them(known);
  for (const std::string& key : keys) {
    const std::string error = one_of_them(key);
    if (!error.empty()) throw CLI::ValidationError("--experiment", error);
  }
}

/// Keeps the lines with claims, and the studies that contain such a line.
void keep_claims(std::vector<study::Study>& studies) {
  for (study::Study& study : studies) {
    for (study::Experiment& experiment : study.experiments) {
      std::erase_if(experiment.lines, [](const study::Line& line) { return !line.claim; });
    }
    std::erase_if(study.experiments,
                  [](const study::Experiment& experiment) { return experiment.lines.empty(); });
  }
  drop_empty(studies);
}

std::string origin() {
  const BuildInfo build = build_info();
  std::ostringstream text;
  text << "stokesbook " << build.version << ", commit " << build.git_hash << ", " << build.compiler
       << " (" << build.flags << "), " << machine_name();
  return text.str();
}

int run_studies(const std::vector<study::Study>& studies, study::Size size,
                const std::filesystem::path& directory) {
  make_folder(directory);
  std::vector<study::StudyResult> results;
  for (const study::Study& study : studies) {
    results.push_back(run(study, size, std::cout));
    write_report(results.back(), origin(), directory);
  }
  write_index(results, origin(), directory);
  std::cout << "tables and figures: " << (directory / "index.html").string() << '\n';
  return std::ranges::all_of(results, &study::StudyResult::holds) ? 0 : exit_claim_fails;
}

}  // namespace

}  // namespace stokesbook

int main(int argc, char** argv) {
  using namespace stokesbook;
  omp_set_num_threads(1);  // makes measured seconds comparable at any load of the machine
  CLI::App app{"Checks the claims of the book; each method has one study"};
  std::vector<study::Study> studies = all_studies();
  std::vector<std::string> methods, known_methods, experiments;
  for (const study::Study& study : studies) known_methods.push_back(study.name);
  study::Size size = study::Size::quick;
  bool only_claims = false;
  std::string directory = "out/study";
  app.add_option("name", methods, "methods to study [all]")->check(CLI::IsMember(known_methods));
  app.add_option("--experiment", experiments,
                 "keys of the experiments to run, with all of their lines [all]")
      ->option_text("KEY ...");
  app.add_option(
         "--size", size,
         "quick: suffices for nearly every claim; full: all claims, with more and harder points")
      ->transform(CLI::CheckedTransformer(std::map<std::string, study::Size>{
          {"quick", study::Size::quick}, {"full", study::Size::full}}));
  app.add_flag("--claims", only_claims, "only the lines with claims, without those for comparison");
  app.add_option("--out", directory, "directory of the results [out/study]");
  try {
    app.parse(argc, argv);
    std::erase_if(studies, [&](const study::Study& study) { return !named(methods, study.name); });
    keep_named(studies, experiments);
    if (only_claims) keep_claims(studies);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  }
  try {
    return run_studies(studies, size, directory);
  } catch (const RecordError& error) {
    std::cerr << "stokes: " << error.what() << '\n';
    return exit_io;
  }
}
