#pragma once

#include <filesystem>
#include <utility>

namespace stokesbook {

/// A lock on a file or folder, which only one object can have at a time. The kernel releases the
/// lock when the process ends, even if it is killed.
class FileLock {
 public:
  /// Waits until no other process has the lock of a file, and takes it. Makes the file, which stays
  /// empty, if necessary.
  static FileLock wait_for(const std::filesystem::path& file);

  /// Takes the lock of a folder. The lock has no effect if the folder cannot be opened, or is on a
  /// file system that cannot lock folders.
  /// @throws RecordError when another object has the lock
  static FileLock of_folder(const std::filesystem::path& folder);

  /// Returns whether a process has the lock of a file at this moment. Makes the file if necessary.
  static bool is_taken(const std::filesystem::path& file);

  /// Takes over the lock of another object, which is left without a lock.
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

  /// Releases the lock.
  ~FileLock();

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace stokesbook
