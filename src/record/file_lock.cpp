// Locks files and folders with flock().
#include "record/file_lock.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "record/atomic_file.hpp"

namespace stokesbook {

namespace {

// Opens the file for writing, since exclusive locks require this on NFS.
int open_file(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw RecordError(path, "opening", {errno, std::generic_category()});
  return descriptor;
}

/// Takes the lock of an open file and returns true, or returns false if another object has it.
bool lock(const std::filesystem::path& file, int descriptor, int operation) {
  while (::flock(descriptor, operation) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) throw RecordError(file, "locking", {errno, std::generic_category()});
  }
  return true;
}

}  // namespace

FileLock FileLock::wait_for(const std::filesystem::path& file) {
  FileLock taken(open_file(file));
  lock(file, taken.descriptor_, LOCK_EX);
  return taken;
}

FileLock FileLock::of_folder(const std::filesystem::path& folder) {
  FileLock taken(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (taken.descriptor_ < 0) return taken;
  if (::flock(taken.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw RecordError(folder, "is being written by another run");
  }
  return taken;
}

bool FileLock::is_taken(const std::filesystem::path& file) {
  const FileLock opened(open_file(file));
  return !lock(file, opened.descriptor_, LOCK_EX | LOCK_NB);
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace stokesbook
