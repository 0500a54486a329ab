// Runs a sweep: its tasks side by side as processes, and then collects a table of their results.
#include "cli/sweep_command.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <omp.h>

#include "cli/message.hpp"
#include "cli/run_command.hpp"
#include "record/atomic_file.hpp"
#include "record/file_lock.hpp"
#include "scene/scene.hpp"
#include "sweep/batch.hpp"
#include "sweep/results.hpp"
#include "sweep/sweep.hpp"
#include "sweep/sweep_folder.hpp"
#include "sweep/task.hpp"
#include "text/text_file.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

/// Runs one task in this process, from its last checkpoint, unless the task is done.
int run_task(const Sweep& sweep, const SweepOptions& options) {
  if (*options.task >= task_count(sweep)) {
    throw SceneError(options.file.string() + ": has " + std::to_string(task_count(sweep)) +
                     " tasks, numbered from 0; there is no task " + std::to_string(*options.task));
  }
  const Task task = require_task(options.out, sweep, *options.task);
  const TaskFolder folder(options.out, task.number);
  make_folder(folder.path());
  const FileLock lock = FileLock::wait_for(folder.lock());
  if (folder.state() == TaskState::done) return exit_done;
  std::error_code ignored;
  fs::remove(folder.failure(), ignored);
  try {
    return run_scene({.scene = sweep.scene,
                      .out = folder.path(),
                      .overrides = task.overrides(),
                      .threads = options.threads,
                      .once = !scene_of(sweep, task).scene.time,
                      .resume = true,
                      .quiet = options.quiet});
  } catch (const std::exception& error) {
    write_atomically(folder.failure(), error.what(), SafeFrom::kill);
    throw;
  }
}

Batch batch_of(const Sweep& sweep, const SweepOptions& options) {
  return {fs::read_symlink("/proc/self/exe"), fs::absolute(options.file), fs::absolute(options.out),
          task_count(sweep), options.threads};
}

/// Returns the numbers, below a number of tasks, of the tasks that are not done.
std::vector<std::size_t> find_tasks_to_do(std::size_t count, const fs::path& out) {
  std::vector<std::size_t> tasks;
  bool is_shared = false;
  for (std::size_t k = 0; k < count; ++k) {
    const TaskFolder folder(out, k);
    if (folder.state() == TaskState::done) continue;
    tasks.push_back(k);
    is_shared = is_shared || FileLock::is_taken(folder.lock());
  }
  // Another sweep works in this folder, beginning with the first task: begin with the last one.
  if (is_shared) std::ranges::reverse(tasks);
  return tasks;
}

/// Runs the tasks that are not done, and returns the number of tasks that failed.
std::size_t run_tasks(const Sweep& sweep, const std::vector<Task>& all,
                      const SweepOptions& options) {
  const std::vector<std::size_t> tasks = find_tasks_to_do(all.size(), options.out);
  const int jobs =
      options.jobs > 0 ? options.jobs : std::max(1, omp_get_num_procs() / options.threads);
  if (!options.quiet) {
    std::printf("%zu tasks, %zu of them to do, %d at a time\n", all.size(), tasks.size(), jobs);
    std::fflush(stdout);
  }
  std::size_t left = tasks.size(), failed = 0;
  run_in_parallel(batch_of(sweep, options), tasks, jobs, [&](std::size_t number, int signal) {
    --left;
    const Task& task = *std::ranges::find(all, number, &Task::number);
    const TaskFolder folder(options.out, number);
    if (signal > 0) {
      const std::string message = "killed by signal " + std::to_string(signal) + ", the last of " +
                                  std::to_string(most_tries) + " tries";
      write_atomically(folder.failure(), message, SafeFrom::kill);
    }
    if (signal > 0 || folder.state() != TaskState::done) {
      const std::string message =
          read_text_file(folder.failure()).value_or("see " + folder.log().string());
      std::fprintf(stderr, "stokes: %s: failed: %s\n", task.description().c_str(),
                   for_terminal(message).c_str());
      ++failed;
    } else if (!options.quiet) {
      std::printf("%s: done, %zu left\n", task.description().c_str(), left);
      std::fflush(stdout);
    }
  });
  return failed;
}

void write_results(const Sweep& sweep, const std::vector<Task>& tasks,
                   const SweepOptions& options) {
  const FileLock lock = FileLock::wait_for(sweep_lock(options.out));
  const std::vector<ResultRow> rows = collect(options.out, sweep, tasks);
  const fs::path path = options.out / "results.csv";
  write_atomically(path, to_csv(sweep, rows), SafeFrom::power_cut);
  if (!options.quiet) std::printf("%sresults in %s\n", to_text(sweep, rows).c_str(), path.c_str());
}

}  // namespace

int run_sweep(SweepOptions options) {
  if (options.out.empty()) options.out = fs::path("out") / options.file.stem();
  const Sweep sweep = read_sweep(options.file);
  if (options.task) return run_task(sweep, options);
  if (options.collect) {
    write_results(sweep, require_sweep(options.out, sweep), options);
    return exit_done;
  }
  const std::vector<Task> tasks = open_sweep(options.out, sweep);
  if (options.plan) {
    const Batch batch = batch_of(sweep, options);
    std::printf("# %zu tasks, listed in %s\n%s", batch.tasks, (options.out / "tasks.csv").c_str(),
                batch_commands(batch).c_str());
    return exit_done;
  }
  const std::size_t failed = run_tasks(sweep, tasks, options);
  write_results(sweep, tasks, options);
  return failed > 0 ? exit_refused : exit_done;
}

}  // namespace stokesbook
