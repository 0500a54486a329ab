// Runs the program stokes: reads the command line, runs the requested command, and turns errors
// into messages and exit codes.
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "cli/analysis_command.hpp"
#include "cli/build_info.hpp"
#include "cli/measure_command.hpp"
#include "cli/message.hpp"
#include "cli/run_command.hpp"
#include "cli/sweep_command.hpp"
#include "record/atomic_file.hpp"
#include "scene/scene.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

std::string version_text() {
  const BuildInfo info = build_info();
  return "stokes " + std::string(info.version) + " (git " +
         joined(std::array{info.git_hash, info.compiler, info.build_type, info.flags}) + ")";
}

// The upper bound exists because OpenMP ends the program if the system cannot start the threads.
const CLI::Range number_of_threads(1, 1024);

void add_scene_options(CLI::App& command, RunOptions& options) {
  command.add_option("scene", options.scene, "scene file (TOML)")->required();
  command.add_option("--out", options.out, "directory for the results [out/<scene name>]");
  command.add_option("--set", options.overrides, "set a value of the scene, such as time.dt=0.01")
      ->allow_extra_args(false);
  command.add_option("--threads", options.threads, "number of threads [all processors]")
      ->check(number_of_threads);
  CLI::Option* const from = command.add_option("--from", options.from,
                                               "begin at the last state of the run in this folder");
  command.add_option("--time", options.from_time, "begin at this written time of that run")
      ->needs(from);
  command.add_flag("--overwrite", options.overwrite, "replace the run in the directory");
  command.add_flag("--dry-run", options.dry_run, "check the scene, print the plan, write nothing");
  command.add_flag("--quiet", options.quiet, "print errors only");
}

void add_sweep_options(CLI::App& command, SweepOptions& options) {
  command.add_option("sweep", options.file, "sweep file (TOML): a scene, values, seeds")
      ->required();
  command.add_option("--out", options.out, "directory for the results [out/<sweep name>]");
  command.add_option("--jobs", options.jobs, "number of tasks at a time [all processors]")
      ->check(CLI::PositiveNumber);
  command.add_option("--threads", options.threads, "number of threads per task [1]")
      ->check(number_of_threads);
  command.add_option("--task", options.task, "run only this task, numbered from 0")
      ->check(CLI::NonNegativeNumber)
      ->excludes("--jobs");
  command.add_flag("--plan", options.plan, "list the tasks, with commands for clusters")
      ->excludes("--jobs")
      ->excludes("--task");
  command.add_flag("--collect", options.collect, "write the table of the finished tasks")
      ->excludes("--jobs")
      ->excludes("--task")
      ->excludes("--plan");
  command.add_flag("--quiet", options.quiet, "print errors only");
}

/// Options of `stokes compare` and `stokes plot`.
struct RunFolders {
  std::filesystem::path run, reference, out;
  std::vector<std::size_t> bodies;
};

void add_compare_options(CLI::App& command, RunFolders& options) {
  command.add_option("run", options.run, "folder of a run")->required();
  command.add_option("reference", options.reference, "folder of another run")->required();
  command.add_option("--out", options.out, "directory for a picture of the differences [none]");
}

void add_plot_options(CLI::App& command, RunFolders& options) {
  command.add_option("run", options.run, "folder of a run")->required();
  command.add_option("--bodies", options.bodies, "bodies whose paths are drawn, such as 0,3,7")
      ->delimiter(',');
  command.add_option("--out", options.out, "directory for the pictures [the folder of the run]");
}

void add_precision_options(CLI::App& command, PrecisionOptions& options) {
  auto& [accuracy, quantity, budget] = options.request;
  command.add_option("scene", options.scene, "scene file (TOML)")->required();
  command.add_option("--accuracy", accuracy, "largest error that is allowed at any time [0.001]")
      ->check(CLI::Range(1e-9, 0.1));
  command.add_option("--quantity", quantity, "a quantity of stokes compare [the trajectory]");
  command.add_option("--budget", budget, "CPU seconds of all runs [600]")
      ->check(CLI::PositiveNumber);
  command.add_option("--set", options.overrides, "set a value of the scene")
      ->allow_extra_args(false);
  command.add_option("--out", options.out, "directory for the results [out/<scene>_precision]");
}

void add_measure_options(CLI::App& command, MeasureOptions& options) {
  command.add_option("run", options.run, "folder of a run")->required();
  command.add_option("--from", options.from, "first time [0]");
  command.add_option("--to", options.to, "last time [end of the run]");
  command
      .add_option("--box", options.box,
                  "xmin,ymin,xmax,ymax: count bodies in this box [between the walls]")
      ->delimiter(',')
      ->expected(4);
  command
      .add_option("--across", options.across, "variable of the profiles: x, y or radius [radius]")
      ->check(CLI::IsMember({"x", "y", "radius"}));
  command.add_option("--longest", options.longest, "longest distance of pairs [8 mean radii]")
      ->check(CLI::PositiveNumber);
  command.add_option("--bins", options.bins, "number of bins [40]")->check(CLI::Range(1, 10000));
  command.add_option("--out", options.out, "directory for the results [the folder of the run]");
}

// Opens /dev/null for each standard stream that is closed. Otherwise, the next file that is opened
// would take the number of the stream, and output for the user would be written into this file.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", O_RDWR);
  }
}

int run_program(int argc, char** argv) {
  open_standard_streams();
  // Without the signal, a write beyond the limit on file sizes fails like one on a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app{"Rigid bodies and walls in two-dimensional Stokes flow"};
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  RunOptions options;
  CLI::App& run = *app.add_subcommand("run", "simulate a scene from t = 0 to its end");
  add_scene_options(run, options);
  run.add_flag("--resume", options.resume,
               "continue from the last checkpoint, also with a later end or other settings")
      ->excludes("--overwrite");
  CLI::Option* verify =
      run.add_flag("--verify", options.verify, "estimate the error of the run by a second run");
  run.add_option("--bound", options.bound, "error whose first excess --verify reports [0.01]")
      ->check(CLI::PositiveNumber)
      ->needs(verify);
  CLI::App& solve = *app.add_subcommand("solve", "solve a scene once, at t = 0");
  add_scene_options(solve, options);
  solve.add_flag("--matrices", options.matrices,
                 "also write resistance and mobility matrix of the free bodies");
  SweepOptions sweep_options;
  CLI::App& sweep = *app.add_subcommand("sweep", "run a scene for many values, with error bars");
  add_sweep_options(sweep, sweep_options);
  RunFolders folders;
  CLI::App& compare = *app.add_subcommand("compare", "print the differences of two runs");
  add_compare_options(compare, folders);
  CLI::App& plot = *app.add_subcommand("plot", "draw the paths and the tables of a run");
  add_plot_options(plot, folders);
  PrecisionOptions precision_options;
  CLI::App& precision = *app.add_subcommand("precision", "find the cheapest accurate settings");
  add_precision_options(precision, precision_options);
  MeasureOptions measure_options;
  CLI::App& measuring =
      *app.add_subcommand("measure", "measure means, distances and profiles of a run");
  add_measure_options(measuring, measure_options);
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_version_flag("--version", version_text());
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help or --version
    std::cerr << for_terminal(error.what()) << "\nRun with --help for more information.\n";
    return exit_bad_usage;
  }
  options.once = solve.parsed();
  const auto& [run_folder, reference, out, bodies] = folders;
  if (compare.parsed()) return compare_runs(run_folder, reference, out);
  if (plot.parsed()) return plot_run(run_folder, bodies, out);
  if (precision.parsed()) return find_precision(precision_options);
  if (measuring.parsed()) return measure_run(measure_options);
  return sweep.parsed() ? run_sweep(sweep_options) : run_scene(options);
}

int report(const std::string& error, int exit_code) {
  std::cerr << "stokes: " << for_terminal(error) << '\n';
  return exit_code;
}

}  // namespace

}  // namespace stokesbook

int main(int argc, char** argv) {
  using namespace stokesbook;
  try {
    const int status = run_program(argc, argv);
    const bool printed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (printed || status != exit_done) return status;
    return report("standard output: could not be written completely", exit_io);
  } catch (const SceneError& error) {
    return report(error.what(), exit_bad_usage);
  } catch (const SolverError& error) {
    return report(std::string("refused: ") + error.what(), exit_refused);
  } catch (const RecordError& error) {
    return report(error.what(), exit_io);
  } catch (const std::filesystem::filesystem_error& error) {
    return report(error.path1().string() + ": " + error.code().message(), exit_io);
  } catch (const std::bad_alloc&) {
    return report("out of memory", exit_refused);
  } catch (const std::exception& error) {
    return report(std::string("internal error: ") + error.what(), exit_internal);
  }
}
