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
  /// @throws RecordError when it exists or cannot be made
  static AppendFile create(const std::filesystem::path& path);

  /// Opens an existing file and drops what follows its first `size` bytes.
  /// @throws RecordError when it is missing or shorter
  static AppendFile reopen(const std::filesystem::path& path, std::uintmax_t size);

  AppendFile(AppendFile&& other) noexcept;
  ~AppendFile();

  /// Appends a record, with one system call if the disk takes it whole, so that a kill leaves whole
  /// records.
  /// @throws RecordError when not all of it could be written; what was written of it is cut off
  void append(std::string_view record);

  /// Returns once the disk has everything.
  /// @throws RecordError when the disk does not take it
  void sync();

  /// Returns the length in bytes.
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
