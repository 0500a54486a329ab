#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A file that grows by whole records and can be cut back to an earlier length.
class AppendFile {
 public:
  /// Makes a new, empty file.
  ///
  /// @param  path  where
  /// @return       the file, open
  /// @throws RecordError when it exists or cannot be made
  static AppendFile create(const std::filesystem::path& path);

  /// Opens an existing file and drops what follows its first `size` bytes.
  ///
  /// @param  path  where
  /// @param  size  length to keep, bytes
  /// @return       the file, open at its new end
  /// @throws RecordError when it is missing, shorter or cannot be cut back
  static AppendFile reopen(const std::filesystem::path& path, std::uintmax_t size);

  /// Takes over an open file.
  /// @param  other  left without one
  AppendFile(AppendFile&& other) noexcept;

  /// Closes the file.
  ~AppendFile();

  /// Appends a record, with one system call if the disk takes it whole, so that a kill leaves whole
  /// records; of one that goes across a page of the file it may leave the part before.
  ///
  /// @param  record  its bytes, with the end of line if it is one
  /// @throws RecordError when not all of it could be written; what was written of it is cut off
  void append(std::string_view record);

  /// Returns once the disk has everything.
  ///
  /// @throws RecordError when the disk does not take it
  void sync();

  /// Returns the length.
  /// @return bytes, whole records only
  std::uintmax_t size() const { return size_; }

 private:
  AppendFile(const std::filesystem::path& path, int flags);

  /// Drops what follows the last whole record; returns whether that worked.
  bool cut_back();

  std::filesystem::path path_;
  int descriptor_;
  std::uintmax_t size_ = 0;
};

/// @}

}  // namespace stokesbook
