#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/sweep.hpp"
#include "sweep/task.hpp"

namespace stokesbook {

/// Writes text on one line as a cell of a CSV file: if the text has commas or quotes, in double
/// quotes, with its own quotes doubled.
std::string csv_cell(std::string_view text);

/// Checks the scenes of all tasks, and makes the folder of a sweep with its manifest `tasks.csv`
/// and the folders of its tasks.
///
/// The columns of the manifest are `task,folder`, the axes, `seed` if the sweep has seeds, and
/// `scene`, a fingerprint of the task's whole scene. Tasks whose scenes are listed in an existing
/// folder keep their numbers and folders; new tasks follow.
/// @return  all tasks by their places, see task_of()
/// @throws SceneError as scene_of() does, and when two tasks have the same scene
/// @throws RecordError when the folder cannot be written, or lists a task that the sweep lacks
std::vector<Task> open_sweep(const std::filesystem::path& out, const Sweep& sweep);

/// Returns the tasks of a sweep whose folder lists all of them, by their places.
///
/// @throws SceneError as open_sweep() does
/// @throws RecordError when the folder lists other tasks than the sweep has
std::vector<Task> require_sweep(const std::filesystem::path& out, const Sweep& sweep);

/// Returns the task of a number; only the scene of this task is read.
///
/// @throws SceneError as scene_of() does
/// @throws RecordError when the folder belongs to no sweep, or when the sweep lacks the values or
///         the scene that the folder lists for this number
Task require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t number);

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

  /// Returns the path of the file with the error message of the last attempt, if that failed.
  std::filesystem::path failure() const { return path_ / "failure.txt"; }

 private:
  std::filesystem::path path_;
};

}  // namespace stokesbook
