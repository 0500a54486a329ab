// Locks files and folders with flock().
#include "record/file_lock.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "record/record_error.hpp"

namespace stokesbook {

namespace {

// Opens the file for writing, since exclusive locks require this on NFS.
int open_file(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw RecordError(path, "opening", {errno, std::generic_category()});
  return descriptor;
}

/// Returns 0, or the error number if the file was not locked.
int lock(int descriptor, int operation) {
  while (::flock(descriptor, operation) != 0) {
    if (errno != EINTR) return errno;
  }
  return 0;
}

}  // namespace

FileLock FileLock::wait_for(const std::filesystem::path& file) {
  FileLock taken(open_file(file));
  const int error = lock(taken.descriptor_, LOCK_EX);
  if (error != 0) throw RecordError(file, "locking", {error, std::generic_category()});
  return taken;
}

FileLock FileLock::of_folder(const std::filesystem::path& folder) {
  FileLock taken(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (taken.descriptor_ >= 0 && lock(taken.descriptor_, LOCK_EX | LOCK_NB) == EWOULDBLOCK) {
    throw RecordError(folder, "is being written by another run");
  }
  return taken;
}

bool FileLock::is_taken(const std::filesystem::path& file) {
  const FileLock open(open_file(file));
  const int error = lock(open.descriptor_, LOCK_EX | LOCK_NB);
  if (error != 0 && error != EWOULDBLOCK) {
    throw RecordError(file, "locking", {error, std::generic_category()});
  }
  return error == EWOULDBLOCK;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace stokesbook
