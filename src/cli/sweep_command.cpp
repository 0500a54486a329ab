// Runs a sweep: starts its tasks as parallel processes, and collects a table of their results.
#include "cli/sweep_command.hpp"

#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include <omp.h>

#include "cli/message.hpp"
#include "cli/run_command.hpp"
#include "record/atomic_file.hpp"
#include "record/file_lock.hpp"
#include "scene/scene.hpp"
#include "sweep/batch.hpp"
#include "sweep/manifest.hpp"
#include "sweep/parse.hpp"
#include "sweep/results.hpp"
#include "sweep/task.hpp"
#include "sweep/task_folder.hpp"
#include "sweep/workers.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

constexpr int most_tries = 3;  // attempts at a task whose worker is killed

/// Runs one task in this process, from its last checkpoint, unless the task is done.
int run_task(const Sweep& sweep, const SweepOptions& options) {
  if (*options.task >= task_count(sweep)) {
    throw SceneError(options.file.string() + ": has " + std::to_string(task_count(sweep)) +
                     " tasks, numbered from 0; there is no task " + std::to_string(*options.task));
  }
  require_task(options.out, sweep, *options.task);
  const TaskFolder folder(options.out, *options.task);
  folder.make();
  const FileLock lock = FileLock::wait_for(folder.lock());
  if (folder.state() == TaskState::done) return exit_done;
  folder.remove_failure();
  try {
    const Task task = task_of(sweep, *options.task);
    return run_scene({.scene = sweep.scene,
                      .out = folder.path(),
                      .overrides = task.overrides(),
                      .threads = options.threads,
                      .once = !scene_of(sweep, task).scene.time,
                      .resume = true,
                      .quiet = options.quiet});
  } catch (const std::exception& error) {
    folder.write_failure(error.what());
    throw;
  }
}

/// Returns the words of the command for a task, without its number. All paths are absolute, so that
/// the command works in every folder.
std::vector<std::string> task_command(const SweepOptions& options) {
  std::error_code unknown;
  const fs::path here = fs::read_symlink("/proc/self/exe", unknown);
  return {(unknown ? fs::absolute(options.program) : here).string(),
          "sweep",
          fs::absolute(options.file).string(),
          "--out",
          fs::absolute(options.out).string(),
          "--threads",
          std::to_string(options.threads),
          "--quiet",
          "--task"};
}

void print_plan(const Sweep& sweep, const SweepOptions& options) {
  const std::vector<std::string> task = task_command(options);
  std::vector<std::string> collect(task.begin(), task.begin() + 5);
  collect.emplace_back("--collect");
  const std::string output =
      in_slurm((fs::absolute(options.out) / "runs").string()) + "/slurm-%a.txt";
  std::printf("# %zu tasks, listed in %s\n%s", task_count(sweep),
              (options.out / "tasks.csv").c_str(),
              batch_commands({task, collect, output, task_count(sweep), options.threads}).c_str());
}

/// The workers of this machine, and the tasks that wait for a worker.
class LocalSweep {
 public:
  LocalSweep(const Sweep& sweep, const SweepOptions& options)
      : sweep_(sweep), options_(options), command_(task_command(options)) {
    for (std::size_t k = 0; k < task_count(sweep); ++k) {
      if (TaskFolder(options.out, k).state() != TaskState::done) waiting_.push_back(k);
    }
  }

  /// Runs all waiting tasks, and returns the number of tasks that failed.
  std::size_t run() {
    const int jobs =
        options_.jobs > 0 ? options_.jobs : std::max(1, omp_get_num_procs() / options_.threads);
    say("%zu tasks, %zu of them to do, %d at a time\n", task_count(sweep_), waiting_.size(), jobs);
    while (!waiting_.empty() || workers_.running() > 0) {
      while (!waiting_.empty() && workers_.running() < static_cast<std::size_t>(jobs)) start_next();
      take_note(workers_.wait());
    }
    return failed_;
  }

 private:
  template <class... Values>
  void say(const char* format, Values... values) const {
    if (options_.quiet) return;
    std::printf(format, values...);
    std::fflush(stdout);
  }

  /// Starts a worker for the next task. Tasks on which another sweep works come last, since their
  /// workers would have to wait.
  void start_next() {
    const auto is_free = [&](std::size_t k) {
      const TaskFolder folder(options_.out, k);
      folder.make();
      return !FileLock::is_taken(folder.lock());
    };
    auto next = std::ranges::find_if(waiting_, is_free);
    if (next == waiting_.end()) next = waiting_.begin();
    const std::size_t task = *next;
    waiting_.erase(next);
    std::vector<std::string> command = command_;
    command.push_back(std::to_string(task));
    workers_.start(task, command, TaskFolder(options_.out, task).log());
  }

  void take_note(const WorkerEnd& end) {
    const std::string task = task_of(sweep_, end.task).description();
    if (end.signal != 0) return take_note_of_kill(end, task);
    const std::size_t left = waiting_.size() + workers_.running();
    if (end.exit_code == exit_done) return say("%s: done, %zu left\n", task.c_str(), left);
    report_failure(end.task, task);
  }

  void take_note_of_kill(const WorkerEnd& end, const std::string& task) {
    const std::string cause = "killed by signal " + std::to_string(end.signal);
    if (++kills_[end.task] < most_tries) {
      std::fprintf(stderr, "stokes: %s: %s; the task continues from its checkpoint\n", task.c_str(),
                   cause.c_str());
      waiting_.push_back(end.task);
      return;
    }
    TaskFolder(options_.out, end.task)
        .write_failure(cause + ", the last of " + std::to_string(most_tries) + " tries");
    report_failure(end.task, task);
  }

  void report_failure(std::size_t number, const std::string& task) {
    const TaskFolder folder(options_.out, number);
    std::string message = folder.failure();
    if (message.empty()) message = "see " + folder.log().string();
    std::fprintf(stderr, "stokes: %s: failed: %s\n", task.c_str(), for_terminal(message).c_str());
    ++failed_;
  }

  const Sweep& sweep_;
  const SweepOptions& options_;
  std::vector<std::string> command_;
  std::deque<std::size_t> waiting_;
  Workers workers_;
  std::map<std::size_t, int> kills_;  // number of kills, by task
  std::size_t failed_ = 0;
};

void write_results(const Sweep& sweep, const SweepOptions& options) {
  const FileLock lock = FileLock::wait_for(sweep_lock(options.out));
  const std::vector<ResultRow> rows = collect(options.out, sweep);
  const fs::path path = options.out / "results.csv";
  write_atomically(path, to_csv(sweep, rows), SafeFrom::power_cut);
  if (!options.quiet) std::printf("%sresults in %s\n", to_text(sweep, rows).c_str(), path.c_str());
}

}  // namespace

int run_sweep(const SweepOptions& given) {
  SweepOptions options = given;
  if (options.out.empty()) options.out = fs::path("out") / options.file.stem();
  const Sweep sweep = read_sweep(options.file);
  if (options.task) return run_task(sweep, options);
  if (options.collect) {
    require_sweep(options.out, manifest(sweep));
    write_results(sweep, options);
    return exit_done;
  }
  open_sweep(options.out, manifest(sweep));
  if (options.plan) {
    print_plan(sweep, options);
    return exit_done;
  }
  const std::size_t failed = LocalSweep(sweep, options).run();
  write_results(sweep, options);
  return failed > 0 ? exit_refused : exit_done;
}

}  // namespace stokesbook
