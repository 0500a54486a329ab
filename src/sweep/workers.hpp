#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// The end of a process that worked on a task.
struct WorkerEnd {
  std::size_t task = 0;  ///< number of the task
  int exit_code = 0;     ///< exit code of the program, unless it was killed
  int signal = 0;        ///< signal that killed the program, or 0
};

/// Processes that work on tasks in parallel. On Linux the kernel kills the processes when the
/// program that started them ends.
class Workers {
 public:
  /// Starts a process.
  ///
  /// @param  task     number of the task
  /// @param  command  path of a program, and its arguments
  /// @param  log      file to which the process appends all that it prints
  /// @throws RecordError when the log cannot be written or the system cannot start a process
  void start(std::size_t task, const std::vector<std::string>& command,
             const std::filesystem::path& log);

  /// Returns the number of processes.
  /// @return number of processes whose end wait() has not returned yet
  std::size_t running() const { return tasks_.size(); }

  /// Waits for the end of the next process; at least one must be running.
  ///
  /// @return the end of the process; a program that could not be started has exit code 127
  /// @throws std::logic_error when no process is running
  WorkerEnd wait();

 private:
  std::map<pid_t, std::size_t> tasks_;
};

/// @}

}  // namespace stokesbook
