#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a file that has just been written is safe from; a power cut costs some milliseconds.
enum class SafeFrom {
  kill,      ///< the program may stop at any moment
  power_cut  ///< the machine too: waits for the disk
};

/// Replaces a file by a new one holding text: at every moment the path holds the old file or the
/// new one, whole.
///
/// The text passes through `<path>.partial`, which a kill may leave behind.
/// @param  path    of the file, new or old
/// @param  text    all that it is to hold
/// @param  danger  what it is to be safe from when this returns
/// @throws RecordError when the disk does not take it; the old file then stays
void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger);

/// Names the file that is written before it takes the place of another.
///
/// @param  path  of that other
/// @return       `<path>.partial`
std::filesystem::path partial_of(const std::filesystem::path& path);

/// Finds the file in whose place another was to come, or to be after a kill.
///
/// @param  path  of any file
/// @return       the path without `.partial` at its end, however often that is there
std::filesystem::path without_partial(std::filesystem::path path);

/// Gives a file another name; at every moment that name is of one of the two, whole.
///
/// @param  from  the file
/// @param  to    its new name, which another may have had
/// @throws RecordError when that does not work; both files then stay
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a file that was written safe from a power cut.
///
/// @param  path  of the file
/// @throws RecordError when the disk does not take it
void sync_file(const std::filesystem::path& path);

/// Makes the names of a directory's files safe from a power cut, on file systems that can.
///
/// @param  directory  whose names; nothing happens where it cannot be opened
void sync_names(const std::filesystem::path& directory);

/// Returns what a file holds.
///
/// @param  path  of the file
/// @return       its bytes
/// @throws RecordError when it cannot be read
std::string read_text(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
