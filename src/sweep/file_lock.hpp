#pragma once

#include <filesystem>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// A lock that one process has at a time. The kernel takes it back when the process ends, however
/// it ends.
class FileLock {
 public:
  /// Waits until no other process has the lock, and takes it.
  ///
  /// @param  path  of the file that stands for the lock; it is made if need be, and stays empty
  /// @throws RecordError when the file cannot be made or locked
  explicit FileLock(const std::filesystem::path& path);

  /// Only one object has a lock.
  FileLock(const FileLock&) = delete;

  /// Gives the lock back.
  ~FileLock();

  /// Tells whether a process has the lock at this moment.
  ///
  /// @param  path  of the file, as above
  /// @return       true when it is locked
  /// @throws RecordError when the file cannot be made or locked
  static bool is_taken(const std::filesystem::path& path);

 private:
  int descriptor_;
};

/// @}

}  // namespace stokesbook
