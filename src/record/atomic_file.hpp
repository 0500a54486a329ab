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

/// Replaces a file by a new one with the given text. At every moment the path names the complete
/// old file or the complete new one.
///
/// The text is written to `<path>.partial` first; a killed program may leave this file behind.
/// @param  path    path of the file, which need not exist
/// @param  text    complete contents of the new file
/// @param  danger  event that the new file survives as soon as the function has returned
/// @throws RecordError when the new file cannot be written; the old file then stays
void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger);

/// Returns the path under which a file is written before it gets its final name.
///
/// @param  path  final path of the file
/// @return       `<path>.partial`
std::filesystem::path partial_of(const std::filesystem::path& path);

/// Returns the final path of a file that a killed program may have left under a partial name.
///
/// @param  path  path of any file
/// @return       the path without `.partial` at its end, even if the ending is repeated
std::filesystem::path without_partial(std::filesystem::path path);

/// Renames a file. At every moment the new name belongs to the complete file that had it before, or
/// to the renamed one.
///
/// @param  from  the file
/// @param  to    its new name; a file with this name is replaced
/// @throws RecordError when the file cannot be renamed; both files then stay
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a written file safe from a power cut.
///
/// @param  path  path of the file
/// @throws RecordError when the disk refuses the data
void sync_file(const std::filesystem::path& path);

/// Makes the names of a directory's files safe from a power cut, on file systems that support this.
///
/// @param  directory  the directory; nothing happens if it cannot be opened
void sync_names(const std::filesystem::path& directory);

/// Returns the contents of a file.
///
/// @param  path  path of the file
/// @return       its bytes
/// @throws RecordError when the file cannot be read
std::string read_text(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
