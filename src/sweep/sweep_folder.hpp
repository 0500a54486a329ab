#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "sweep/sweep.hpp"

namespace stokesbook {

/// Writes text on one line as a cell of a CSV file: if the text has commas or quotes, in double
/// quotes, with its own quotes doubled.
std::string csv_cell(std::string_view text);

/// Writes `tasks.csv`, the list of a sweep's tasks, and checks the scene of each.
///
/// The columns are `task,folder`, the axes, `seed` if the sweep has seeds, and `scene`, a
/// fingerprint of the task's whole scene.
/// @throws SceneError as scene_of() does, and when two tasks have the same scene
std::string manifest(const Sweep& sweep);

/// Makes the folder of a sweep with its manifest and the folders of its tasks, or checks that an
/// existing folder belongs to the same sweep.
///
/// @throws SceneError as manifest() does
/// @throws RecordError when the folder cannot be written, or belongs to another sweep
void open_sweep(const std::filesystem::path& out, const Sweep& sweep);

/// Checks that a folder belongs to a sweep, by its whole manifest.
///
/// @throws SceneError as manifest() does
/// @throws RecordError when the folder belongs to no sweep or to another one
void require_sweep(const std::filesystem::path& out, const Sweep& sweep);

/// Checks that a folder belongs to a sweep, by the row of one task in the manifest.
///
/// @throws SceneError as scene_of() does
/// @throws RecordError when the folder belongs to no sweep, or when the task has other values or
///         another scene
void require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t task);

/// Returns the path of the FileLock that protects the files of the whole sweep.
std::filesystem::path sweep_lock(const std::filesystem::path& out);

/// The state of a task.
enum class TaskState {
  unfinished,  ///< not begun, under way, or killed
  done,        ///< its run reached its end
  failed       ///< the last attempt ended with an error
};

/// The folder of a task: the folder of its run, with the additional files `lock`, `log.txt` and,
/// after an error, `failure.txt`.
class TaskFolder {
 public:
  /// Refers to the folder of a task, which need not exist, in the folder of its sweep.
  TaskFolder(const std::filesystem::path& out, std::size_t task) : path_(out / name(task)) {}

  /// Returns the path of a task's folder, relative to the folder of the sweep: "runs/0007", with
  /// more digits if four do not suffice.
  static std::string name(std::size_t task);

  /// Returns the path of the folder.
  const std::filesystem::path& path() const { return path_; }

  /// Returns the path of the file for warnings and errors of the task's processes.
  std::filesystem::path log() const { return path_ / "log.txt"; }

  /// Returns the path of the FileLock of the process that works on the task.
  std::filesystem::path lock() const { return path_ / "lock"; }

  /// Reads the state of the task from its files.
  /// @throws RecordError when `run.json` is damaged
  TaskState state() const;

  /// Returns the error message of the last attempt; empty if the attempt did not fail.
  std::string failure() const;

  /// Stores the error message of an attempt.
  /// @throws RecordError when the file cannot be written
  void write_failure(std::string_view message) const;

  /// Removes the error message of the last attempt.
  void remove_failure() const;

 private:
  std::filesystem::path failure_file() const { return path_ / "failure.txt"; }

  std::filesystem::path path_;
};

}  // namespace stokesbook
