// Compares, plots and verifies runs, and searches for settings by runs that are processes.
#include "cli/analysis_command.hpp"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <tuple>

#include <sys/resource.h>
#include <sys/wait.h>

#include "analysis/comparison.hpp"
#include "analysis/plots.hpp"
#include "cli/run_command.hpp"
#include "record/atomic_file.hpp"
#include "record/run_info.hpp"
#include "scene/write.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "sweep/batch.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

void write_files(const std::map<std::string, std::string>& files, const fs::path& out) {
  make_folder(out);
  for (const auto& [name, text] : files) write_atomically(out / name, text, SafeFrom::kill);
}

/// Returns the CPU time of all processes that this one has started and that have ended, seconds.
double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto& [user, system] = std::tie(usage.ru_utime, usage.ru_stime);
  return static_cast<double>(user.tv_sec + system.tv_sec) +
         1e-6 * static_cast<double>(user.tv_usec + system.tv_usec);
}

/// Runs a scene as a process with one thread, for at most some seconds of CPU time.
Outcome run_process(const Scene& scene, double most_seconds, const fs::path& out) {
  write_files({{"scene.toml", to_toml({scene})}}, out);
  const fs::path log = out / "log.txt";
  // If this process is killed, the kernel interrupts the run.
  const std::string command =
      "ulimit -t " + short_number(std::ceil(most_seconds), 9) + "; exec setpriv --pdeathsig INT " +
      shell_quoted(fs::read_symlink("/proc/self/exe").string()) + " run " +
      shell_quoted((out / "scene.toml").string()) + " --out " + shell_quoted(out.string()) +
      " --overwrite --quiet --threads 1 2> " + shell_quoted(log.string());
  const double before = seconds_of_children();
  const int status = std::system(command.c_str());
  Outcome outcome{.seconds = seconds_of_children() - before};
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) throw RecordError(out, "was interrupted");
  if (status == 0) {
    outcome.run = read_run(out);
    outcome.nodes = most_nodes_of(out);
  } else {
    outcome.failure = WIFSIGNALED(status) ? "the run took too long" : read_text(log);
  }
  return outcome;
}

}  // namespace

int compare_runs(const fs::path& run, const fs::path& reference, const fs::path& out) {
  const Run first = read_run(run), second = read_run(reference);
  const Comparison comparison = compare(first, second);
  std::printf("%zu common times of %zu and %zu written ones; nothing is interpolated\n%s",
              comparison.t.size(), first.times().size(), second.times().size(),
              to_text(comparison).c_str());
  if (!out.empty()) write_files({{"comparison.svg", draw(comparison)}}, out);
  return exit_done;
}

int plot_run(const fs::path& run, std::vector<std::size_t> bodies, const fs::path& out) {
  const Run plotted = read_run(run);
  if (bodies.empty()) bodies = bodies_to_draw(plotted.scene);
  const auto pictures = draw_run(plotted, bodies);
  write_files(pictures, out.empty() ? run : out);
  for (const auto& [name, _] : pictures) {
    std::printf("%s\n", ((out.empty() ? run : out) / name).c_str());
  }
  std::printf("paths of %zu of %zu bodies; --bodies chooses them\n", bodies.size(),
              plotted.scene.bodies.size());
  return exit_done;
}

int find_precision(const PrecisionOptions& options) {
  const Scene scene = load_scene(options.scene, options.overrides).scene;
  const fs::path out = options.out.empty()
                           ? fs::path("out") / (options.scene.stem().string() + "_precision")
                           : options.out;
  const fs::path trials = out / "trials";
  if (fs::exists(trials)) {
    throw RecordError(trials, "has the runs of another search; remove it, or give another --out");
  }
  std::size_t runs = 0;
  const auto run = [&](const Scene& changed, double most_seconds) {
    Outcome outcome = run_process(changed, most_seconds, trials / padded_number(runs++, 4));
    std::printf("run %zu: %s CPU seconds%s%s\n", runs, short_number(outcome.seconds).c_str(),
                outcome.failure.empty() ? "" : ", ", outcome.failure.c_str());
    std::fflush(stdout);
    return outcome;
  };
  const Search result = search(scene, options.request, run);
  const std::string table = result.trials.empty() ? "" : to_text(result);
  std::printf("%stwo references differ by %s; %s CPU seconds\n", table.c_str(),
              short_number(result.reference_error).c_str(), short_number(result.seconds).c_str());
  if (!result.best) throw SolverError(options.scene.string() + ": " + result.failure);
  const Settings& best = result.trials[*result.best].settings;
  std::map<std::string, std::string> files = draw(result, options.request);
  files["precision.txt"] = table;
  files["recommended.toml"] = to_toml({with_settings(scene, best)});
  write_files(files, out);
  std::printf("cheapest settings for the accuracy %s: %s\nscene with these settings: %s\n",
              short_number(options.request.accuracy).c_str(), to_text(best).c_str(),
              (out / "recommended.toml").c_str());
  return exit_done;
}

std::string verification_report(const fs::path& run, double bound) {
  const Comparison comparison = compare(read_run(run), read_run(run / "verify"));
  write_files({{"comparison.svg", draw(comparison)}}, run / "verify");
  const auto [at_end, exceeds, rate] = judge_growth(comparison.t, comparison.trajectory, bound);
  return "error of positions in radii and of angles, estimated by a second run: " +
         short_number(at_end) + " at the end; " +
         (exceeds ? "above " + short_number(bound) + " first at t = " + short_number(*exceeds, 6)
                  : "at most " + short_number(bound) + " at all written times") +
         (rate ? "; it grows like exp(" + short_number(*rate) + " t): log(error) is linear in t\n"
               : "; it does not grow exponentially: log(error) is not linear in t\n");
}

}  // namespace stokesbook
