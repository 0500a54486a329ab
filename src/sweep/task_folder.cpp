#include "sweep/task_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "record/atomic_file.hpp"
#include "record/record_error.hpp"
#include "record/run_info.hpp"

namespace stokesbook {

namespace {

constexpr const char* failure_name = "failure.txt";

void make(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RecordError(folder, "making the directory", error);
}

int open_lock_file(const std::filesystem::path& folder) {
  make(folder);
  const int descriptor = ::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    throw RecordError(folder / "lock", "opening", {errno, std::generic_category()});
  }
  return descriptor;
}

/// Locks the file; returns whether another has it locked, which it cannot when asked to wait.
bool is_taken(int descriptor, int operation, const std::filesystem::path& folder) {
  while (::flock(descriptor, operation) != 0) {
    if (errno == EWOULDBLOCK) return true;
    if (errno != EINTR) {
      throw RecordError(folder / "lock", "locking", {errno, std::generic_category()});
    }
  }
  return false;
}

}  // namespace

TaskLock::TaskLock(TaskLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

TaskLock::~TaskLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

TaskFolder::TaskFolder(const std::filesystem::path& out, std::size_t task)
    : path_(out / name(task)) {}

std::string TaskFolder::name(std::size_t task) {
  const std::string digits = std::to_string(task);
  return "runs/" + std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits;
}

std::filesystem::path TaskFolder::log() const {
  make(path_);
  return path_ / "log.txt";
}

TaskState TaskFolder::state() const {
  if (exit_status_of(path_) == 0) return TaskState::done;
  std::error_code unreadable;
  return std::filesystem::exists(path_ / failure_name, unreadable) ? TaskState::failed
                                                                   : TaskState::unfinished;
}

bool TaskFolder::is_locked() const {
  const int descriptor = open_lock_file(path_);
  const TaskLock returned_at_once(descriptor);
  return is_taken(descriptor, LOCK_EX | LOCK_NB, path_);
}

TaskLock TaskFolder::lock() const {
  const int descriptor = open_lock_file(path_);
  TaskLock lock(descriptor);
  is_taken(descriptor, LOCK_EX, path_);
  return lock;
}

std::string TaskFolder::failure() const {
  std::error_code unreadable;
  if (!std::filesystem::exists(path_ / failure_name, unreadable)) return {};
  return read_text(path_ / failure_name);
}

void TaskFolder::write_failure(std::string_view message) const {
  write_atomically(path_ / failure_name, message, SafeFrom::kill);
}

void TaskFolder::remove_failure() const {
  std::error_code none;
  std::filesystem::remove(path_ / failure_name, none);
}

}  // namespace stokesbook
