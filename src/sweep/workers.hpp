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

/// How the process that worked on a task ended.
struct WorkerEnd {
  std::size_t task = 0;  ///< its number
  int exit_code = 0;     ///< of the program, unless it was killed
  int signal = 0;        ///< that killed it, or 0
};

/// Processes that work on tasks, side by side. They end when the program that started them does, on
/// systems that see to it.
class Workers {
 public:
  /// Starts a process.
  ///
  /// @param  task     its number
  /// @param  command  path of a program, and its arguments
  /// @param  log      file to which the process appends all that it prints
  /// @throws RecordError when the log cannot be written, or the system starts no process
  void start(std::size_t task, const std::vector<std::string>& command,
             const std::filesystem::path& log);

  /// Counts the processes.
  /// @return how many have not been waited for
  std::size_t running() const { return tasks_.size(); }

  /// Waits for the next process to end; one must be running.
  ///
  /// @return how it ended; a program that could not be started has exit code 127
  /// @throws std::logic_error when there is none
  WorkerEnd wait();

 private:
  std::map<pid_t, std::size_t> tasks_;
};

/// @}

}  // namespace stokesbook
