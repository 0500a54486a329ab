// Locks a file with flock(), so that processes wait for each other.
#include "sweep/file_lock.hpp"

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

FileLock::FileLock(const std::filesystem::path& path) : descriptor_(open_file(path)) {
  const int error = lock(descriptor_, LOCK_EX);
  if (error == 0) return;
  ::close(descriptor_);
  throw RecordError(path, "locking", {error, std::generic_category()});
}

FileLock::~FileLock() {
  ::close(descriptor_);
}

bool FileLock::is_taken(const std::filesystem::path& path) {
  const int descriptor = open_file(path);
  const int error = lock(descriptor, LOCK_EX | LOCK_NB);
  ::close(descriptor);
  if (error != 0 && error != EWOULDBLOCK) {
    throw RecordError(path, "locking", {error, std::generic_category()});
  }
  return error == EWOULDBLOCK;
}

}  // namespace stokesbook
