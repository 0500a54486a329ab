#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A file that grows by records and can be cut back to an earlier length.
///
/// A program that is killed while it appends a record may leave a part of the record in the file;
/// GrowingFile avoids this.
class AppendFile {
 public:
  /// Makes a new, empty file.
  ///
  /// @param  path  path of the file
  /// @return       the open file
  /// @throws RecordError when the file exists or cannot be made
  static AppendFile create(const std::filesystem::path& path);

  /// Opens an existing file and cuts it back to its first `size` bytes.
  ///
  /// @param  path  path of the file
  /// @param  size  length to keep, bytes
  /// @return       the file, open at its new end
  /// @throws RecordError when the file is missing, shorter, a symbolic link or not a regular file,
  ///         or cannot be cut back
  static AppendFile reopen(const std::filesystem::path& path, std::uintmax_t size);

  /// Takes over the open file of another object.
  /// @param  other  the other object, which is left without a file
  AppendFile(AppendFile&& other) noexcept;

  /// Exchanges the open files of two objects.
  /// @param  other  the other object, which closes the file that it receives when it is destroyed
  /// @return        this object
  AppendFile& operator=(AppendFile&& other) noexcept;

  /// Closes the file.
  ~AppendFile();

  /// Appends a record.
  ///
  /// @param  record  bytes of the record, including the end of its line
  /// @throws RecordError when the record cannot be written completely; its written part is cut off
  void append(std::string_view record);

  /// Waits until all records are on the disk.
  ///
  /// @throws RecordError when the disk refuses the data
  void sync();

  /// Returns whether the object has an open file.
  /// @return false after another object has taken the file over
  bool is_open() const { return descriptor_ >= 0; }

  /// Returns the length of the file.
  /// @return bytes of all complete records
  std::uintmax_t size() const { return size_; }

 private:
  AppendFile(const std::filesystem::path& path, int flags);

  /// Cuts off everything after the last complete record, and returns whether this succeeded.
  bool cut_back();

  std::filesystem::path path_;
  int descriptor_;
  std::uintmax_t size_ = 0;
};

/// @}

}  // namespace stokesbook
