#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a file that has just been written is safe from; a power cut costs some milliseconds.
enum class SafeFrom { kill, power_cut };

/// Replaces a file by a new one holding text: at every moment the path holds the old file or the
/// new one, whole.
///
/// The text passes through `<path>.partial`, which a kill may leave behind.
/// @throws RecordError when the disk does not take it; the old file then stays
void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger);

/// Returns whether a path is that of a file which write_atomically had not finished.
bool is_partial(const std::filesystem::path& path);

/// Makes a file that was written safe from a power cut.
/// @throws RecordError when the disk does not take it
void sync_file(const std::filesystem::path& path);

/// Makes the names of a directory's files safe from a power cut, on file systems that can.
void sync_names(const std::filesystem::path& directory);

/// Returns what a file holds.
/// @throws RecordError when it cannot be read
std::string read_text(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
