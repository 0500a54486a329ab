#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "record/append_file.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// A file that grows by complete records: a program that opens its path never finds an incomplete
/// record, even after a kill.
///
/// There are two copies, which take turns. Records are appended to the copy `<path>.partial`;
/// publish() renames this copy to `<path>`, renames the older copy to `<path>.partial`, and appends
/// the missing records to it. Each record is thus written twice, whatever the length of the file.
class GrowingFile {
 public:
  /// Opens an existing file and cuts it back to its first `size` bytes.
  ///
  /// @param  path  path of the file
  /// @param  size  length to keep, bytes
  /// @throws RecordError when the file is missing or shorter, or cannot be written
  GrowingFile(const std::filesystem::path& path, std::uintmax_t size);

  /// Takes over the open file of another object.
  /// @param  other  the other object, which is left without a file
  GrowingFile(GrowingFile&& other) noexcept = default;

  /// Publishes the remaining records, unless the disk refuses them, and closes the file.
  ~GrowingFile();

  /// Appends a record, which readers of the path see after publish().
  ///
  /// @param  record  bytes of the record, including the end of its line
  /// @throws RecordError when the record cannot be written completely
  void append(std::string_view record) { partial_.append(record); }

  /// Moves all records to the file at the path, and waits until they are on the disk.
  ///
  /// The name of the file is safe from a power cut only after sync_names().
  /// @throws RecordError when the disk refuses the data; no record may be appended after that
  void publish();

  /// Returns the length.
  /// @return bytes, including records that are not published yet
  std::uintmax_t size() const { return partial_.size(); }

 private:
  /// Appends to the partial copy the records that only the published file has.
  void catch_up();

  std::filesystem::path path_;
  std::uintmax_t published_;  ///< length of the file at path_
  AppendFile partial_;
};

/// @}

}  // namespace stokesbook
