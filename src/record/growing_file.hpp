#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "record/append_file.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// A file that grows by whole records: whoever opens its path never finds a part of one, even after
/// a kill.
///
/// Two files take turns. Records go to `<path>.partial`; publish() gives it the name of the file
/// and then goes on with the one that had it, with the records that this one lacks. Each record is
/// thus written twice, whatever the length of the file.
class GrowingFile {
 public:
  /// Opens an existing file and drops what follows its first `size` bytes.
  ///
  /// @param  path  where
  /// @param  size  length to keep, bytes
  /// @throws RecordError when it is missing, shorter, or cannot be written
  GrowingFile(const std::filesystem::path& path, std::uintmax_t size);

  /// Takes over an open file.
  /// @param  other  left without one
  GrowingFile(GrowingFile&& other) noexcept = default;

  /// Publishes the records of which the disk takes all, and closes the file.
  ~GrowingFile();

  /// Appends a record that publish() will show.
  ///
  /// @param  record  its bytes, with the end of line if it is one
  /// @throws RecordError when not all of it could be written
  void append(std::string_view record) { partial_.append(record); }

  /// Shows all records; when it returns, the disk has them.
  ///
  /// The name of the file is safe from a power cut after sync_names() only.
  /// @throws RecordError when the disk does not take it; nothing is to be appended then
  void publish();

  /// Returns the length.
  /// @return bytes, with records that are not published
  std::uintmax_t size() const { return partial_.size(); }

 private:
  /// Appends what the published file has beyond the end of the other.
  void catch_up();

  std::filesystem::path path_;
  std::uintmax_t published_;  ///< length of the file at path_
  AppendFile partial_;
};

/// @}

}  // namespace stokesbook
