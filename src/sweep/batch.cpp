// Writes the shell commands of a sweep for Slurm and GNU parallel, and runs tasks by the latter.
#include "sweep/batch.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <sys/wait.h>

#include "record/atomic_file.hpp"

namespace stokesbook {

namespace {

std::string replaced(std::string_view text, char letter, std::string_view replacement) {
  std::string result;
  for (const char c : text) result += c == letter ? replacement : std::string_view(&c, 1);
  return result;
}

/// Returns the command for a sweep, to which an option is appended that selects what it does.
std::string sweep_command(const Batch& batch) {
  return shell_quoted(batch.program.string()) + " sweep " + shell_quoted(batch.sweep.string()) +
         " --out " + shell_quoted(batch.out.string());
}

/// Returns the command for a task, to which the number of the task is appended.
std::string task_command(const Batch& batch) {
  return sweep_command(batch) + " --threads " + std::to_string(batch.threads) + " --quiet --task ";
}

/// Returns the command that runs the tasks whose numbers are in the standard input.
///
/// GNU parallel repeats a job unless its exit code is 0. Only a task that was killed is to be tried
/// again, and a shell reports a signal as exit code 128 + signal: all other codes become 0.
std::string parallel_command(const Batch& batch, const std::string& options = "") {
  const std::string start =
      "exec >> " + shell_quoted((batch.out / "runs").string()) + "/$(printf %04d ";
  // GNU parallel replaces {} and the like; '{''}' is the same word, in which it finds none.
  const auto literal = [](const std::string& text) { return replaced(text, '{', "{''"); };
  const std::string job = literal(start) + "{})/log.txt 2>&1; " + literal(task_command(batch)) +
                          "{} || exit $(($? > 128 ? $? : 0))";
  return "env PARALLEL_SHELL=/bin/sh parallel --will-cite --retries " + std::to_string(most_tries) +
         options + " " + shell_quoted(job);
}

}  // namespace

std::string shell_quoted(std::string_view word) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./=:,@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string_view::npos) {
    return std::string(word);
  }
  return "'" + replaced(word, '\'', "'\\''") + "'";
}

std::string batch_commands(const Batch& batch) {
  const std::string last = std::to_string(batch.tasks - 1);
  // Slurm replaces patterns such as %a in the path of the output; %% stands for %.
  const std::string output = replaced((batch.out / "runs").string(), '%', "%%") + "/slurm-%a.txt";
  return "# Slurm: one job per task; submit again to run the tasks that are not done\n"
         "sbatch --array=0-" +
         last + " --cpus-per-task=" + std::to_string(batch.threads) +
         " --requeue --open-mode=append --output=" + shell_quoted(output) +
         " --wrap=" + shell_quoted(task_command(batch) + "$SLURM_ARRAY_TASK_ID") +
         "\n"
         "# GNU parallel: one task per processor; --sshlogin adds machines with the same files\n"
         "seq 0 " +
         last + " | " + parallel_command(batch) +
         "\n"
         "# when all have ended: the table\n" +
         sweep_command(batch) + " --collect\n";
}

void run_in_parallel(const Batch& batch, std::span<const std::size_t> tasks, int jobs,
                     const std::function<void(std::size_t task, int signal)>& report) {
  if (tasks.empty()) return;
  const auto require = [](bool success, const char* file, const char* action) {
    if (!success) throw RecordError(file, action, {errno, std::generic_category()});
  };
  // GNU parallel reads the numbers of the tasks from a file without a name.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> numbers(std::tmpfile(), std::fclose);
  require(numbers != nullptr, "a temporary file", "opening");
  for (const std::size_t task : tasks) std::fprintf(numbers.get(), "%zu\n", task);
  require(std::fflush(numbers.get()) == 0, "a temporary file", "writing");
  // If this process is killed, the kernel interrupts GNU parallel, which then ends its jobs.
  const std::string command =
      "command -v parallel > /dev/null || exit 127; exec setpriv --pdeathsig INT " +
      parallel_command(batch, " --ungroup --joblog - --jobs " + std::to_string(jobs)) +
      " < /dev/fd/" + std::to_string(::fileno(numbers.get()));
  std::FILE* joblog = ::popen(command.c_str(), "r");
  require(joblog != nullptr, "GNU parallel", "starting");
  // Each line of the log: number of the job from 1, host, start, seconds, two sizes, exit code,
  // signal, command. The first line has the names of these columns.
  std::size_t ended = 0;
  char* line = nullptr;
  for (std::size_t size = 0; ::getline(&line, &size, joblog) > 0;) {
    std::size_t job = 0;
    int exit_code = 0, signal = 0;
    constexpr const char* columns = "%zu %*s %*s %*s %*s %*s %d %d";
    if (std::sscanf(line, columns, &job, &exit_code, &signal) != 3) continue;
    ++ended;
    report(tasks[job - 1], signal > 0 ? signal : exit_code > 128 ? exit_code - 128 : 0);
  }
  std::free(line);
  const int status = ::pclose(joblog);
  if (ended == tasks.size()) return;
  const bool is_missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
  throw RecordError("GNU parallel", is_missing
                                        ? "is not installed; install the package parallel, or run "
                                          "the tasks by the commands of --plan"
                                        : "ended before all tasks had ended; the same command "
                                          "continues the sweep");
}

}  // namespace stokesbook
