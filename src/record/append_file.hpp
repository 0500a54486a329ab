#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A file that grows by records and can be cut back to an earlier length.
///
/// A kill in the middle of a record leaves what went into the pages of the file before the next; see
/// GrowingFile where that matters.
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
  /// @throws RecordError when it is missing, shorter, a symbolic link or no regular file, or cannot
  /// be cut back
  static AppendFile reopen(const std::filesystem::path& path, std::uintmax_t size);

  /// Takes over an open file.
  /// @param  other  left without one
  AppendFile(AppendFile&& other) noexcept;

  /// Takes over an open file in exchange for its own.
  /// @param  other  left with that, which it closes in the end
  /// @return        this one
  AppendFile& operator=(AppendFile&& other) noexcept;

  /// Closes the file.
  ~AppendFile();

  /// Appends a record.
  ///
  /// @param  record  its bytes, with the end of line if it is one
  /// @throws RecordError when not all of it could be written; what was written of it is cut off
  void append(std::string_view record);

  /// Returns once the disk has everything.
  ///
  /// @throws RecordError when the disk does not take it
  void sync();

  /// Tells whether there is a file.
  /// @return false once another object has taken it over
  bool is_open() const { return descriptor_ >= 0; }

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
