#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// How far a task has come.
enum class TaskState {
  unfinished,  ///< not begun, under way, or killed
  done,        ///< its run reached its end
  failed       ///< the last try ended with an error
};

/// Folder of a task: that of its run, with the files `lock`, `log.txt` and, after an error,
/// `failure.txt`.
class TaskFolder {
 public:
  /// Names the folder of a task; makes nothing.
  ///
  /// @param  out   folder of the sweep
  /// @param  task  its number
  TaskFolder(const std::filesystem::path& out, std::size_t task);

  /// Names the folder of a task within that of the sweep.
  ///
  /// @param  task  its number
  /// @return       "runs/0007"; more digits where four do not do
  static std::string name(std::size_t task);

  /// Returns the folder.
  /// @return its path
  const std::filesystem::path& path() const { return path_; }

  /// Makes the folder, if need be.
  ///
  /// @throws RecordError when it cannot be made
  void make() const;

  /// Returns where the output of its workers goes.
  /// @return path of `log.txt`
  std::filesystem::path log() const { return path_ / "log.txt"; }

  /// Returns the FileLock of who works on the task.
  /// @return path of `lock`
  std::filesystem::path lock() const { return path_ / "lock"; }

  /// Looks how far the task has come.
  /// @return its state
  /// @throws RecordError when `run.json` is damaged
  TaskState state() const;

  /// Says how the last try failed.
  /// @return message; empty without failure
  std::string failure() const;

  /// Notes how a try failed.
  /// @param  message  for people
  /// @throws RecordError when the disk does not take it
  void write_failure(std::string_view message) const;

  /// Forgets how the last try failed.
  void remove_failure() const;

 private:
  std::filesystem::path path_;
};

/// @}

}  // namespace stokesbook
