// Manages the folder of a task, and reads the state of the task from its files.
#include "sweep/task_folder.hpp"

#include <algorithm>
#include <system_error>

#include "record/atomic_file.hpp"
#include "record/record_error.hpp"
#include "record/run_info.hpp"

namespace stokesbook {

std::string TaskFolder::name(std::size_t task) {
  const std::string digits = std::to_string(task);
  return "runs/" + std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits;
}

void TaskFolder::make() const {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw RecordError(path_, "making the directory", error);
}

TaskState TaskFolder::state() const {
  if (exit_status_of(path_) == 0) return TaskState::done;
  std::error_code unreadable;
  return std::filesystem::exists(failure_file(), unreadable) ? TaskState::failed
                                                             : TaskState::unfinished;
}

std::string TaskFolder::failure() const {
  std::error_code unreadable;
  return std::filesystem::exists(failure_file(), unreadable) ? read_text(failure_file()) : "";
}

void TaskFolder::write_failure(std::string_view message) const {
  write_atomically(failure_file(), message, SafeFrom::kill);
}

void TaskFolder::remove_failure() const {
  std::error_code none;
  std::filesystem::remove(failure_file(), none);
}

}  // namespace stokesbook
