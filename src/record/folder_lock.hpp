#pragma once

#include <filesystem>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A lock on a folder, which only one object can have at a time. The kernel releases the lock when
/// the process ends, even if it is killed.
class FolderLock {
 public:
  /// Takes the lock. On file systems that cannot lock folders, the lock has no effect.
  ///
  /// @param  folder  the folder; nothing happens if it cannot be opened
  /// @throws RecordError when another object has the lock
  explicit FolderLock(const std::filesystem::path& folder);

  /// Takes over the lock of another object.
  /// @param  other  the other object, which is left without a lock
  FolderLock(FolderLock&& other) noexcept;

  /// Releases the lock.
  ~FolderLock();

 private:
  int descriptor_;
};

/// @}

}  // namespace stokesbook
