#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace stokesbook {

/// A file could not be read or written; the message names the file and the reason.
struct RecordError : std::runtime_error {
  /// Constructs the message `path: reason`.
  RecordError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error(path.string() + ": " + reason) {}

  /// Constructs the message `path: action failed: cause`, with an action such as "writing".
  RecordError(const std::filesystem::path& path, const std::string& action, std::error_code cause)
      : RecordError(path, action + " failed: " + cause.message()) {}
};

/// Makes a folder, and the folders in which it lies, unless they exist.
void make_folder(const std::filesystem::path& path);

/// The event that a new file must survive. Safety from a power cut costs some milliseconds.
enum class SafeFrom {
  kill,      ///< the program is killed at any moment
  power_cut  ///< the machine stops too; the function waits for the disk
};

/// Replaces a file, which need not exist, by a new one with the given text. At every moment the
/// path names the complete old file or the complete new one.
///
/// The text is written to `<path>.partial` first; a killed program may leave this file behind. The
/// new file survives the `danger` from the moment when the function returns.
/// @throws RecordError when the new file cannot be written; the old file then stays
void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger);

/// Removes the ending `.partial` from a path, even if the ending is repeated.
std::filesystem::path without_partial(std::filesystem::path path);

/// Makes a written file safe from a power cut.
void sync_file(const std::filesystem::path& path);

/// Makes the names of a directory's files safe from a power cut, if the directory can be opened and
/// the file system supports this.
void sync_names(const std::filesystem::path& directory);

/// A file that grows by records and can be cut back to an earlier length.
///
/// append() keeps records in memory; flush() writes all of them by one call. A program that is
/// killed during this call may leave an incomplete record at the end of the file, which reopen()
/// cuts off.
class AppendFile {
 public:
  /// Makes a new, empty file.
  /// @throws RecordError when the file exists or cannot be made
  static AppendFile create(const std::filesystem::path& path);

  /// Opens an existing file and cuts it back to its first `size` bytes.
  /// @throws RecordError when the file is missing, shorter, a symbolic link or not a regular file,
  ///         or cannot be cut back
  static AppendFile reopen(const std::filesystem::path& path, std::uintmax_t size);

  /// Takes over the open file of another object, which is left without a file.
  AppendFile(AppendFile&& other) noexcept;

  /// Writes the remaining records, unless the disk refuses them, and closes the file.
  ~AppendFile();

  /// Adds a record, which the file contains after flush().
  void append(std::string_view record) { waiting_ += record; }

  /// Writes all records to the file.
  /// @throws RecordError when the records cannot be written completely; their written part is cut
  ///         off, and they are lost
  void flush();

  /// Writes all records to the file, and waits until they are on the disk.
  void sync();

  /// Returns the bytes of all records, including those that are not in the file yet.
  std::uintmax_t size() const { return size_ + waiting_.size(); }

 private:
  AppendFile(const std::filesystem::path& path, int flags);

  /// Cuts the file back to size_ bytes, and returns whether this succeeded.
  bool cut_back();

  std::filesystem::path path_;
  int descriptor_;
  std::uintmax_t size_ = 0;  ///< length of the file
  std::string waiting_;      ///< records that are not in the file yet
};

/// Returns the bytes of a file.
std::string read_text(const std::filesystem::path& path);

}  // namespace stokesbook
