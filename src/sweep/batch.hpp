#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace stokesbook {

/// A sweep whose tasks run as processes of their own. All paths are absolute, so that the commands
/// work in every folder.
struct Batch {
  std::filesystem::path program;  ///< the program stokes
  std::filesystem::path sweep;    ///< sweep file
  std::filesystem::path out;      ///< folder of the sweep, in which each task has its folder
  std::size_t tasks = 1;          ///< number of tasks, at least one
  int threads = 1;                ///< threads of each task
};

/// Number of attempts at a task whose process is killed. A task that fails is not tried again.
inline constexpr int most_tries = 3;

/// Quotes a word so that a POSIX shell, Slurm's `--wrap` and GNU parallel take it literally.
std::string shell_quoted(std::string_view word);

/// Writes commands for a POSIX shell, with their titles as comments: they run all tasks as an array
/// of Slurm jobs, or by GNU parallel, and collect the results.
std::string batch_commands(const Batch& batch);

/// Runs tasks, which must have their folders, by GNU parallel with the command of batch_commands().
///
/// If this process is killed, GNU parallel ends the processes of its tasks.
/// @param  jobs    number of tasks that run at a time
/// @param  report  called at the end of each task with its number, and with the signal that killed
///                 the last of its tries, or 0
/// @throws RecordError when GNU parallel is not installed, or ends before all tasks have ended
void run_in_parallel(const Batch& batch, std::span<const std::size_t> tasks, int jobs,
                     const std::function<void(std::size_t task, int signal)>& report);

}  // namespace stokesbook
