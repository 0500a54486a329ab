#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// The event that a new file must survive. Safety from a power cut costs some milliseconds.
enum class SafeFrom {
  kill,      ///< the program is killed at any moment
  power_cut  ///< the machine stops too; the function waits for the disk
};

/// Replaces a file, which need not exist, by a new one with the given text. At every moment the
/// path names the complete old file or the complete new one.
///
/// The text is written to `<path>.partial` first; a killed program may leave this file behind.
/// @param  danger  event that the new file survives as soon as the function has returned
/// @throws RecordError when the new file cannot be written; the old file then stays
void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger);

/// Returns the path that a file would have without `.partial` at its end, even if the ending is
/// repeated.
std::filesystem::path without_partial(std::filesystem::path path);

/// Makes a written file safe from a power cut.
/// @throws RecordError when the disk refuses the data
void sync_file(const std::filesystem::path& path);

/// Makes the names of a directory's files safe from a power cut, if the directory can be opened and
/// the file system supports this.
void sync_names(const std::filesystem::path& directory);

/// Returns the bytes of a file.
/// @throws RecordError when the file cannot be read
std::string read_text(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
