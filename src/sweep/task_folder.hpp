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

/// The right to work on a task, which one process has at a time. The kernel takes it back when the
/// process ends, however it ends.
class TaskLock {
 public:
  /// Takes over a lock.
  /// @param  descriptor  of the locked file
  explicit TaskLock(int descriptor) : descriptor_(descriptor) {}
  /// Takes over a lock.
  /// @param  other  left without one
  TaskLock(TaskLock&& other) noexcept;
  /// Gives the right back.
  ~TaskLock();

 private:
  int descriptor_;
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

  /// Makes the folder, if need be, and returns where the output of its workers goes.
  ///
  /// @return path of `log.txt`
  /// @throws RecordError when the folder cannot be made
  std::filesystem::path log() const;

  /// Looks how far the task has come.
  /// @return its state
  /// @throws RecordError when `run.json` is damaged
  TaskState state() const;

  /// Tells whether another process works on the task at this moment.
  /// @return true when it is locked
  /// @throws RecordError when the lock file cannot be made
  bool is_locked() const;

  /// Waits until no other process works on the task.
  /// @return the right to do so
  /// @throws RecordError when the lock file cannot be made
  TaskLock lock() const;

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
