#pragma once

#include <filesystem>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// A lock that only one process can have at a time. The kernel releases the lock when the process
/// ends, even if it is killed.
class FileLock {
 public:
  /// Waits until no other process has the lock, and takes it.
  ///
  /// @param  path  path of the lock file, which is made if necessary and stays empty
  /// @throws RecordError when the file cannot be made or locked
  explicit FileLock(const std::filesystem::path& path);

  /// Deleted: a lock cannot be copied.
  FileLock(const FileLock&) = delete;

  /// Releases the lock.
  ~FileLock();

  /// Returns whether a process has the lock at this moment.
  ///
  /// @param  path  path of the lock file
  /// @return       true if the file is locked
  /// @throws RecordError when the file cannot be made or locked
  static bool is_taken(const std::filesystem::path& path);

 private:
  int descriptor_;
};

/// @}

}  // namespace stokesbook
