#pragma once

#include <filesystem>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A lock on a folder that one object has at a time. The kernel takes it back when the process ends,
/// however it ends.
class FolderLock {
 public:
  /// Takes the lock. Where the file system locks no folders, nobody is kept out.
  ///
  /// @param  folder  to be locked; nothing happens where it cannot be opened
  /// @throws RecordError when another has the lock
  explicit FolderLock(const std::filesystem::path& folder);

  /// Takes over a lock.
  /// @param  other  left without one
  FolderLock(FolderLock&& other) noexcept;

  /// Gives the lock back.
  ~FolderLock();

 private:
  int descriptor_;
};

/// @}

}  // namespace stokesbook
